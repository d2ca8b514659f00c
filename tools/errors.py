# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The one error that dev.py shows as a sentence instead of a traceback."""


class DevError(Exception):
    """Something the developer can act upon: what is wrong, where, and what to do."""
