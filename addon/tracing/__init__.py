# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tasks that trace: curvature lines, umbilics and hatching of many objects."""
