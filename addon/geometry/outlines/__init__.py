# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves on a surface as points: borders of regions, level curves of a quantity."""
