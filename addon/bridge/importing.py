# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Models from files, through Blender's own importers."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import bmesh
import bpy
import numpy as np
from bpy.types import Context, Mesh, Object

from .mesh import positions


class ImportRefusedError(ValueError):
    """A file cannot be read as a model; the message says why."""


_Importer = Callable[[str, str | None], object]


def _with_axes(module: str, name: str) -> _Importer:
    """Return a call of an importer that lets the user choose the axis that points up."""

    def load(filepath: str, up: str | None) -> object:
        forward = {"Y": "NEGATIVE_Z", "Z": "Y"}
        axes = {"up_axis": up, "forward_axis": forward[up]} if up else {}
        return getattr(getattr(bpy.ops, module), name)(filepath=filepath, **axes)

    return load


def _plain(module: str, name: str) -> _Importer:
    """Return a call of an importer whose format says itself which axis points up."""
    return lambda filepath, _up: getattr(getattr(bpy.ops, module), name)(filepath=filepath)


def _fbx(filepath: str, _up: str | None) -> object:
    # Blender 4.5 has a new importer in C++ beside the add-on that older ones have.
    if "fbx_import" in dir(bpy.ops.wm):
        return bpy.ops.wm.fbx_import(filepath=filepath)
    return bpy.ops.import_scene.fbx(filepath=filepath)


_IMPORTERS: dict[str, _Importer] = {
    ".obj": _with_axes("wm", "obj_import"),
    ".ply": _with_axes("wm", "ply_import"),
    ".stl": _with_axes("wm", "stl_import"),
    ".glb": _plain("import_scene", "gltf"),
    ".gltf": _plain("import_scene", "gltf"),
    ".usd": _plain("wm", "usd_import"),
    ".usda": _plain("wm", "usd_import"),
    ".usdc": _plain("wm", "usd_import"),
    ".usdz": _plain("wm", "usd_import"),
    ".abc": _plain("wm", "alembic_import"),
    ".fbx": _fbx,
}

#: Formats in which faces that do not look smooth do not share vertices.
_SPLIT = (".glb", ".gltf")

ENDINGS = (".blend", *_IMPORTERS)
"""Endings of the files that can be read."""


def load_model(context: Context, path: Path, up: str | None = None) -> list[Object]:
    """Open a Blender file, or import another into an empty one, and return its mesh objects.

    Parameters
    ----------
    context : Context
    path : Path
    up : str, optional
        Y or Z: the axis that points up in formats that do not say it; None for Blender's default.

    Returns
    -------
    list of Object
        The mesh objects that renders show; at least one.

    Raises
    ------
    ImportRefusedError
        If the file is missing, unreadable, of an unknown kind, or without a mesh.
    """
    if not path.is_file():
        raise ImportRefusedError("there is no such file")
    ending = path.suffix.lower()
    if ending not in ENDINGS:
        raise ImportRefusedError(f"cannot read '{ending}' files; known are {' '.join(ENDINGS)}")
    try:
        if ending == ".blend":
            bpy.ops.wm.open_mainfile(filepath=str(path.resolve()), load_ui=False)
        else:
            bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
            _IMPORTERS[ending](str(path.resolve()), up)
            for mesh in bpy.data.meshes:
                _forget_shading(mesh, is_split=ending in _SPLIT)
    except RuntimeError as error:
        raise ImportRefusedError(f"Blender cannot read it: {_first_line(error)}") from error
    objects = [obj for obj in context.view_layer.objects if _is_model(obj)]
    if not objects:
        raise ImportRefusedError("there is no mesh with faces in it")
    return objects


def _forget_shading(mesh: Mesh, is_split: bool) -> None:
    """Give an imported mesh the shape that its file describes, however it is shaded.

    Importers mark edges sharp between faces of different normals. Those are all edges of a model
    that was written with flat shading; the crease angle finds the true ones.
    """
    sharp = mesh.attributes.get("sharp_edge")
    if sharp is not None:
        mesh.attributes.remove(sharp)
    if is_split:
        model = bmesh.new()
        model.from_mesh(mesh)
        bmesh.ops.remove_doubles(model, verts=model.verts[:], dist=_weld_distance(mesh))
        model.to_mesh(mesh)
        model.free()
    mesh.update()


def _weld_distance(mesh: Mesh) -> float:
    """Return the rounding of a mesh's coordinates."""
    stored = positions(mesh)
    return float(np.spacing(np.abs(stored).max(initial=0.0)))


def _is_model(obj: Object) -> bool:
    links = obj.curvature
    is_made = links.source is not None or links.companion_of is not None
    is_own = obj.type == "MESH" and not obj.hide_render and not is_made
    return is_own and bool(len(obj.data.polygons) or obj.modifiers)


def _first_line(error: RuntimeError) -> str:
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    return lines[0].removeprefix("Error: ") if lines else "unknown error"
