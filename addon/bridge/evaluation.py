# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects with their modifiers applied, also those that Blender skips for being hidden."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import bpy
from bpy.types import Depsgraph, LayerCollection, Mesh, Object


@contextmanager
def evaluated_object(obj: Object, depsgraph: Depsgraph) -> Iterator[Object]:
    """Give an object as its modifiers and shape keys make it, as long as the block runs.

    Blender does not evaluate what is disabled in viewports or lies in an excluded collection: the
    source behind a copy of ours often does. A stand-in is evaluated in its place then.
    """
    if _is_enabled(obj, depsgraph.view_layer.layer_collection):
        yield obj.evaluated_get(depsgraph)
        return
    stand_in = obj.copy()
    stand_in.hide_viewport = False
    depsgraph.scene.collection.objects.link(stand_in)
    try:
        depsgraph.update()
        yield stand_in.evaluated_get(depsgraph)
    finally:
        bpy.data.objects.remove(stand_in)


@contextmanager
def evaluated_mesh(obj: Object, depsgraph: Depsgraph) -> Iterator[Mesh]:
    """Give an object's mesh with its modifiers applied, as long as the block runs."""
    with evaluated_object(obj, depsgraph) as evaluated:
        try:
            yield evaluated.to_mesh()
        finally:
            evaluated.to_mesh_clear()


def _is_enabled(obj: Object, layer: LayerCollection) -> bool:
    """Return whether an object is evaluated; objects that are merely hidden are."""
    if obj.hide_viewport or layer.exclude or layer.collection.hide_viewport:
        return False
    is_here = layer.collection.objects.get(obj.name) == obj
    return is_here or any(_is_enabled(obj, child) for child in layer.children)
