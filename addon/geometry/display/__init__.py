# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is shown and how: colors, ranges and legends as numbers, without drawing."""
