# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines on a surface as curve objects of Blender, and back."""

from __future__ import annotations

from dataclasses import dataclass

import bpy
import numpy as np
from bpy.types import Curve, Object, Scene, Spline

from ..geometry.fitting import BezierCurve
from ..geometry.types import Floats, Indices
from .companions import (
    ROLES,
    add_companion,
    companion_name,
    companion_points,
    companions,
)
from .material import plain_material
from .mesh import read_array
from .subject import Subject
from .units import meters_per_unit

LENGTHS, ENDS, ALONG = "curvature_lengths", "curvature_ends", "curvature_along"
"""Custom properties of curves: meters per spline, ends per spline, curvature per point."""

SPACING, DEVIATION = "curvature_spacing", "curvature_deviation"
"""Custom properties of curves: meters between lines, and from the surface of fitted ones."""

_ALIGNED = "ALIGNED"


@dataclass(frozen=True)
class LineSet:
    """Lines to write as one object.

    Parameters
    ----------
    lines : list of (p, 3) float64 or BezierCurve
        In meters, in the coordinates of the analyzed mesh. Closed polylines do not repeat their
        first point.
    is_closed : list of bool
    lengths : (n,) float64
        In meters.
    ends : (n, 2) int64
        Values of `LineEnd`.
    along : list of (p,) float64
        A curvature per point or knot.
    radii : list of (p,) float64, optional
        Share of the thickness per point; all 1 by default.
    spacing, deviation : float
        Between lines, and of fitted ones from the surface, in meters; 0 for those of no interest.
    """

    lines: list[Floats | BezierCurve]
    is_closed: list[bool]
    lengths: Floats
    ends: Indices
    along: list[Floats]
    radii: list[Floats] | None = None
    spacing: float = 0.0
    deviation: float = 0.0


def write_curves(
    subject: Subject, carrier: Object, lines: LineSet, role: str, thickness: float, scene: Scene
) -> Object:
    """Add lines to the curve object of a role, which is made where it is missing.

    Parameters
    ----------
    subject : Subject
        The analysis that the lines were traced on.
    carrier : Object
    lines : LineSet
    role : str
        A key of `ROLES`.
    thickness : float
        Diameter of the lines in meters.
    scene : Scene

    Returns
    -------
    Object
    """
    found = companions(subject.source, (role,))
    # Lines that were picked on an earlier state of the model stay what they are.
    obj = found[0] if found else _add_object(subject, carrier, role, scene)
    data = obj.data
    data.bevel_depth = 0.5 * thickness / meters_per_unit(scene)
    for number, line in enumerate(lines.lines):
        if isinstance(line, BezierCurve):
            _add_bezier(data, subject, obj, line)
        else:
            radii = lines.radii[number] if lines.radii else None
            place = companion_points(subject, obj, line)
            _add_polyline(data, place, lines.is_closed[number], radii)
    for key, values in (
        (LENGTHS, lines.lengths.tolist()),
        (ENDS, lines.ends.ravel().tolist()),
        (ALONG, np.concatenate(lines.along).tolist() if lines.along else []),
    ):
        _extend(data, key, values)
    for key, length in ((SPACING, lines.spacing), (DEVIATION, lines.deviation)):
        _keep_longest(data, key, length)
    return obj


def polylines(obj: Object, scene: Scene) -> list[tuple[Floats, bool]]:
    """Return the splines of a curve object as polylines in world coordinates, in meters.

    Returns
    -------
    list of ((p, 3) float64, bool)
        Points of each line, and whether it is closed; then the first is not repeated.
    """
    world = np.array(obj.matrix_world, dtype=np.float64)
    scale = meters_per_unit(scene)
    found = []
    for spline in obj.data.splines:
        points = _spline_points(spline) @ world[:3, :3].T + world[:3, 3]
        found.append((scale * points, bool(spline.use_cyclic_u)))
    return found


def line_lengths(obj: Object) -> list[float]:
    """Return the lengths of the lines that an object was made of, in meters."""
    return [float(length) for length in obj.data.get(LENGTHS, ())]


def stored_length(obj: Object, key: str) -> float:
    """Return a length in meters that an object of lines keeps, `SPACING` for one; 0 for none."""
    return float(obj.data.get(key, 0.0))


def _add_object(subject: Subject, carrier: Object, role: str, scene: Scene) -> Object:
    data = bpy.data.curves.new(companion_name(subject.source, role), "CURVE")
    data.dimensions = "3D"
    data.bevel_resolution = 1
    data.use_fill_caps = True
    name = f"Curvature {ROLES[role].ending.removeprefix('Picked ')}"
    data.materials.append(plain_material(name, ROLES[role].color))
    obj = add_companion(subject.source, carrier, data, role, scene)
    obj.curvature.fingerprint = subject.fingerprint
    return obj


def _extend(data: Curve, key: str, values: list[float] | list[int]) -> None:
    """Add values to a custom property; an empty list has no type that Blender could store."""
    if values:
        data[key] = [*data.get(key, ()), *values]


def _keep_longest(data: Curve, key: str, length: float) -> None:
    """Keep a length, other than none, unless a longer one is kept already."""
    if length:
        data[key] = max(length, data.get(key, 0.0))


def _add_polyline(data: Curve, points: Floats, is_closed: bool, radii: Floats | None) -> None:
    rows = np.ones((len(points), 4), dtype=np.float32)
    rows[:, :3] = points
    spline = data.splines.new("POLY")
    spline.points.add(len(rows) - 1)
    spline.points.foreach_set("co", rows.ravel())
    if radii is not None:
        spline.points.foreach_set("radius", radii.astype(np.float32))
    spline.use_cyclic_u = is_closed


def _add_bezier(data: Curve, subject: Subject, obj: Object, curve: BezierCurve) -> None:
    spline = data.splines.new("BEZIER")
    spline.bezier_points.add(len(curve.knots) - 1)
    points = spline.bezier_points
    for key, values in (
        ("co", curve.knots),
        ("handle_left", curve.before),
        ("handle_right", curve.after),
    ):
        place = companion_points(subject, obj, values).astype(np.float32)
        points.foreach_set(key, place.ravel())
    for point in points:
        point.handle_left_type = point.handle_right_type = _ALIGNED
    spline.use_cyclic_u = curve.is_closed


def _spline_points(spline: Spline) -> Floats:
    if spline.type != "BEZIER":
        return read_array(spline.points, "co", np.float32, 4)[:, :3].astype(np.float64)
    knots, before, after = (
        read_array(spline.bezier_points, key, np.float32, 3).astype(np.float64)
        for key in ("co", "handle_left", "handle_right")
    )
    number = np.arange(len(knots))
    curve = BezierCurve(knots, before, after, number, bool(spline.use_cyclic_u))
    points = curve.samples()
    # Where arcs meet, one ends with the point that the next begins with.
    is_first = np.ones(len(points), dtype=np.bool_)
    is_first[1:] = (np.diff(points, axis=0) != 0.0).any(axis=1)
    points = points[is_first]
    is_double = spline.use_cyclic_u and len(points) > 1 and np.allclose(points[0], points[-1])
    return points[:-1] if is_double else points
