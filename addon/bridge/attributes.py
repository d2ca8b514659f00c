# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Named attributes of a mesh: written, read and removed, never doubled."""

from __future__ import annotations

import numpy as np
from bpy.types import Mesh

from ..geometry.types import AnyArray
from .mesh import read_array

_FIELD = {"FLOAT": "value", "INT": "value", "FLOAT_VECTOR": "vector", "FLOAT_COLOR": "color"}
_TYPE = {
    "FLOAT": np.float32,
    "INT": np.int32,
    "FLOAT_VECTOR": np.float32,
    "FLOAT_COLOR": np.float32,
}
_WIDTH = {"FLOAT": 1, "INT": 1, "FLOAT_VECTOR": 3, "FLOAT_COLOR": 4}


def write_attribute(mesh: Mesh, name: str, domain: str, kind: str, values: AnyArray) -> None:
    """Write an attribute, which is made anew where it is missing or of another kind.

    Parameters
    ----------
    mesh : Mesh
        Not in Edit Mode.
    name : str
    domain : str
        POINT, EDGE, FACE or CORNER.
    kind : str
        FLOAT, INT, FLOAT_VECTOR or FLOAT_COLOR.
    values : (n,) or (n, width) array
        One row per item of the domain.
    """
    attribute = mesh.attributes.get(name)
    if attribute is not None and (attribute.domain, attribute.data_type) != (domain, kind):
        mesh.attributes.remove(attribute)
        attribute = None
    if attribute is None:
        attribute = mesh.attributes.new(name, kind, domain)
    attribute.data.foreach_set(_FIELD[kind], np.ascontiguousarray(values, _TYPE[kind]).ravel())


def read_attribute(mesh: Mesh, name: str) -> AnyArray | None:
    """Return the values of an attribute, one row per item of its domain; None if missing."""
    attribute = mesh.attributes.get(name)
    if attribute is None or attribute.data_type not in _FIELD:
        return None
    kind = attribute.data_type
    return read_array(attribute.data, _FIELD[kind], _TYPE[kind], _WIDTH[kind])


def remove_attributes(mesh: Mesh, names: tuple[str, ...]) -> int:
    """Remove attributes by name, those that exist, and return how many there were."""
    found = [name for name in names if name in mesh.attributes]
    for name in found:
        mesh.attributes.remove(mesh.attributes[name])
    return len(found)


def show_color_attribute(mesh: Mesh, name: str) -> None:
    """Make a color attribute the one that the viewport and renders show."""
    mesh.color_attributes.active_color_name = name
    mesh.color_attributes.render_color_index = mesh.color_attributes.find(name)
