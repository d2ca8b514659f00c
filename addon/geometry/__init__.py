# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Differential geometry of polygon meshes on arrays, without Blender.

The modules are imported one by one where they are needed: scipy and libigl take a noticeable part
of a second to load, which Blender's start must not pay for.
"""
