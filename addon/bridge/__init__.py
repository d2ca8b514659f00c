# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Between Blender and arrays: the only place that reads meshes and writes what was found."""
