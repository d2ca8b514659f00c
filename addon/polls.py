# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether an operator can run, and what to do where it cannot."""

from __future__ import annotations

from bpy.types import Context, Object, Operator

from .bridge import display
from .bridge.drawings import DRAWN_ROLES


def has_mesh(operator: type[Operator], context: Context) -> bool:
    """Ask for a mesh object in Object or Edit Mode."""
    if context.mode not in {"OBJECT", "EDIT_MESH"}:
        operator.poll_message_set("Switch to Object or Edit Mode")
        return False
    if not _selected_meshes(context):
        operator.poll_message_set("Select a mesh object")
        return False
    return True


def has_active_mesh(operator: type[Operator], context: Context) -> bool:
    """Ask for an active mesh object in Object or Edit Mode."""
    if not has_mesh(operator, context):
        return False
    active = context.object
    if active is None or not (active.type == "MESH" or active.curvature.companion_of):
        operator.poll_message_set("Make a mesh object the active one")
        return False
    return True


def has_results(operator: type[Operator], context: Context) -> bool:
    """Ask for an analyzed mesh somewhere in the scene."""
    if context.mode not in {"OBJECT", "EDIT_MESH"}:
        operator.poll_message_set("Switch to Object or Edit Mode")
        return False
    if not display.analyzed_objects(context.scene):
        operator.poll_message_set("Analyze or segment a model first")
        return False
    return True


def has_classes(operator: type[Operator], context: Context) -> bool:
    """Ask for a selected mesh that is segmented."""
    if not has_mesh(operator, context):
        return False
    if not any(obj.data.curvature.is_segmented for obj in display.analyzed_objects(context.scene)):
        operator.poll_message_set("Segment the model first")
        return False
    return True


def has_scene(operator: type[Operator], context: Context) -> bool:
    """Ask for a scene: Blender has none while it loads a file."""
    if context.scene is None:
        operator.poll_message_set("Open a scene first")
        return False
    return True


def has_lines(operator: type[Operator], context: Context) -> bool:
    """Ask for a selected mesh, and curves of a model in the scene."""
    if not has_mesh(operator, context):
        return False
    # An empty set of lines has no object.
    if not any(obj.curvature.role in DRAWN_ROLES for obj in context.scene.objects):
        operator.poll_message_set("Trace curvature lines first")
        return False
    return True


def _selected_meshes(context: Context) -> list[Object]:
    objects = [*context.selected_objects, *context.objects_in_mode_unique_data]
    return [obj for obj in objects if obj.type == "MESH" or obj.curvature.companion_of]
