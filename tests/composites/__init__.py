# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Composite surfaces with exact classes: what a segmentation has to find.

Each is made of pieces whose curvature is known, as quads or random triangles, with seams on mesh
lines or anywhere, clean or with noise along the normals. Equal arguments give equal meshes.
"""
