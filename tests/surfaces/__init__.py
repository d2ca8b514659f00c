# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact surfaces: meshes whose normals, principal curvatures and directions come from formulas.

`catalogue.PATCHES` lists parametrized surfaces, `sampling.sample_patch` puts a mesh on one;
`spheres.sample_ellipsoid` does so for closed ellipsoids. Curvatures are positive where the
surface bends away from its normals, as on a sphere with normals outward, and k1 >= k2. Nothing here
knows the code under test, and equal arguments give equal meshes.
"""
