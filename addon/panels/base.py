# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What all panels have in common."""

from __future__ import annotations

from bpy.types import Context, Mesh

from ..bridge.subject import carrier_of


class SidebarPanel:
    """A panel in the sidebar of the 3D viewport."""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Curvature"


def active_results_mesh(context: Context) -> Mesh | None:
    """Return the mesh that carries the results of the active object, None without results."""
    active = context.object
    if active is None or active.type != "MESH":
        return None
    mesh = carrier_of(active).data
    return mesh if isinstance(mesh, Mesh) and mesh.curvature.fingerprint else None
