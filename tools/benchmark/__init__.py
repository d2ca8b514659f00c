# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The estimator beside its peers on exact surfaces: `python3 dev.py bench accuracy | speed`.

Seeds are fixed, so errors repeat to the last digit printed; times do not.
"""
