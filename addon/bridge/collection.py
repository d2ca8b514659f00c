# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The collection that keeps what was made for an object."""

from __future__ import annotations

import bpy
from bpy.types import Collection, Object, Scene

_ENDING = " Curvature"


def link_beside(source: Object, made: Object, scene: Scene) -> None:
    """Put an object into the collection `<name> Curvature` of its source, in the same scene."""
    name = f"{source.name}{_ENDING}"
    collection = bpy.data.collections.get(name)
    if collection is None or collection.library is not None:
        collection = bpy.data.collections.new(name)
    if collection not in scene.collection.children_recursive:
        scene.collection.children.link(collection)
    if made.name not in collection.objects:
        collection.objects.link(made)


def discard(source: Object, made: list[Object]) -> bool:
    """Remove objects that were made for a source, their data, and collections left empty.

    Returns
    -------
    bool
        Whether there were any.
    """
    homes = {home for each in made for home in _own_collections(each)}
    for obj in made:
        data = obj.data
        bpy.data.objects.remove(obj)
        if not data.users:
            bpy.data.batch_remove([data])
    named = bpy.data.collections.get(f"{source.name}{_ENDING}")
    for collection in {*homes, *([named] if named else [])}:
        if not collection.objects and not collection.children:
            bpy.data.collections.remove(collection)
    return bool(made)


def _own_collections(made: Object) -> list[Collection]:
    """Return the collections of ours that an object lies in, also where its source was renamed."""
    return [each for each in made.users_collection if each.name.endswith(_ENDING)]
