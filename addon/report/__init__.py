# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reports as plain data and files: no Blender, so that any program can make and read them."""
