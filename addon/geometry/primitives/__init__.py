# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that buildings are made of, fitted to points: plane, sphere, cylinder, cone, torus."""
