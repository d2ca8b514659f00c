# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Classes as a designer would draw them: few and clean areas, borders where they belong."""
