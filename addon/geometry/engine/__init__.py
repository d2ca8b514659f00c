# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Principal curvatures of a triangle mesh.

One estimator for clean, noisy, coarse and open meshes.
"""
