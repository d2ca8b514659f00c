# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A field that is ready to be traced, and lines through given points."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..curvature import Curvature
from ..surface import Surface
from ..types import Flags, Floats, Indices
from .areas import find_areas
from .assembly import assemble
from .calming import calmed
from .endings import Rules, Surroundings, surroundings
from .field import PRINCIPAL, DirectionField, Family, build_direction_field
from .filling import filled
from .lines import CurvatureLines
from .refinement import smoothed
from .samples import Samples, no_trail, take_samples
from .seeds import Seeds, make_seeds
from .tracing import trace
from .transport import build_transport
from .umbilics import Umbilics, find_umbilics

#: What stands for the spacing of lines without one, over the side of a triangle.
_SPACING = 4.0
#: Share of it at which a line ends beside itself.
_NEAREST = 0.5


@dataclass(frozen=True)
class LineField:
    """The direction field of a surface with its umbilics.

    Parameters
    ----------
    field : DirectionField
    umbilics : Umbilics
    """

    field: DirectionField
    umbilics: Umbilics

    @cached_property
    def no_samples(self) -> Samples:
        """Samples of no line."""
        return take_samples(self.field, no_trail())

    @property
    def own_spacing(self) -> float:
        """What stands for the spacing of lines without one, in meters."""
        return _SPACING * self.field.mesh.edge_length

    @cached_property
    def own_surroundings(self) -> Surroundings:
        """The umbilics for lines without a spacing: under the mouse they are traced many times."""
        return surroundings(self.field, self.umbilics, self.own_spacing)


def build_line_field(
    surface: Surface,
    curvature: Curvature,
    smoothing_length: float | None = None,
    umbilic_tolerance: float = 0.0,
) -> LineField:
    """Return the direction field of a surface, freed from noise, and its umbilics.

    Parameters
    ----------
    surface : Surface
    curvature : Curvature
        Of this surface.
    smoothing_length : float, optional
        Length in meters over which directions are averaged, 0 for none; by default as the
        uncertainty of the curvature asks for.
    umbilic_tolerance : float
        Half the difference of k1 and k2 in 1/m up to which a part counts as flat or spherical; 0
        for a default that depends on the model's size.

    Returns
    -------
    LineField
    """
    field = build_direction_field(surface, curvature, umbilic_tolerance)
    transport = build_transport(field.mesh, field.normal)
    field = smoothed(field, transport, smoothing_length)
    areas = find_areas(field, transport)
    field = filled(field, transport, areas.zone >= 0, areas)
    field = calmed(field, transport, areas)
    return LineField(field, find_umbilics(field, transport, areas))


def trace_from(
    lines: LineField,
    triangle: Indices,
    barycentric: Floats,
    families: tuple[Family, ...] = PRINCIPAL,
) -> CurvatureLines:
    """Trace the lines through points on the surface, each for itself.

    Parameters
    ----------
    lines : LineField
    triangle : (n,) int64
        Triangle of each point.
    barycentric : (n, 3) float64
        Place in it.
    families : tuple of Family

    Returns
    -------
    CurvatureLines
        Family by family, in the order of the points. Points on umbilics and in umbilic areas have
        no lines.
    """
    rules = own_rules(lines)
    seeds = make_seeds(
        np.tile(triangle, len(families)),
        np.tile(barycentric, (len(families), 1)),
        np.repeat(np.array(families, dtype=np.int64), len(triangle)),
    )
    seeds = usable(lines, seeds)
    state, samples = trace(lines.field, lines.own_surroundings, seeds, lines.no_samples, rules)
    return assemble(lines.field, state, samples, rules, 0.0)


def own_rules(lines: LineField) -> Rules:
    """Return when lines end that are traced each for itself."""
    spacing = lines.own_spacing
    return Rules(spacing=spacing, nearest=_NEAREST * spacing, competes=False)


def usable(lines: LineField, seeds: Seeds) -> Seeds:
    """Return the seeds at which there is a direction."""
    return seeds.chosen(is_usable(lines, seeds.triangle, seeds.barycentric, seeds.family))


def is_usable(lines: LineField, triangle: Indices, barycentric: Floats, family: Indices) -> Flags:
    """Return the points at which there is a direction, (n,) bool."""
    strength = lines.field.evaluate(triangle, barycentric, family)[2]
    return (strength > 0.0) & (lines.umbilics.triangle_area[triangle] < 0)
