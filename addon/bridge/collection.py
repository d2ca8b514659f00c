# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The collection that keeps what was made for an object."""

from __future__ import annotations

import bpy
from bpy.types import Collection, Object, Scene


def link_beside(source: Object, made: Object, scene: Scene) -> None:
    """Put an object into the collection `<name> Curvature` of its source, in the same scene."""
    name = f"{source.name} Curvature"
    collection = bpy.data.collections.get(name)
    if collection is None or collection.library is not None:
        collection = bpy.data.collections.new(name)
    if collection not in scene.collection.children_recursive:
        scene.collection.children.link(collection)
    if made.name not in collection.objects:
        collection.objects.link(made)


def remove_if_empty(source: Object) -> None:
    """Remove the collection of a source where nothing is left in it."""
    collection: Collection | None = bpy.data.collections.get(f"{source.name} Curvature")
    if collection is not None and not collection.objects and not collection.children:
        bpy.data.collections.remove(collection)
