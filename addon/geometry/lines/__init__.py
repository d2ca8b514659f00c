# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines along the directions of curvature, and the umbilics where there are none.

`build_direction_field` makes a line field of a `Curvature`, `find_umbilics` its singularities,
`trace_evenly` and `trace_from` follow it. The modules are imported one by one.
"""
