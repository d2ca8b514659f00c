# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Direction fields of objects, measured where they are not at hand."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from ..bridge import cache
from ..bridge.subject import Reading, Subject
from ..geometry.lines.field import Family
from ..geometry.lines.layout import trace_evenly
from ..geometry.lines.lines import CurvatureLines
from ..geometry.lines.tracer import LineField, build_line_field
from ..geometry.places import PlaceFinder
from ..geometry.progress import part_of
from ..geometry.types import Progress
from ..tasks import criterion_of
from .settings import Plan, Sizes, check_resolution, resolve_sizes

#: Share of the time for a field that the analysis takes.
_ANALYSIS = 0.8


@dataclass(frozen=True)
class Field:
    """An analyzed object, its directions, and the lengths that its lines have."""

    subject: Subject
    lines: LineField
    sizes: Sizes

    @cached_property
    def finder(self) -> PlaceFinder:
        """Finds places on the surface; it takes a while to make."""
        return PlaceFinder(self.subject.analysis.surface)


def find_field(reading: Reading, plan: Plan, on_progress: Progress) -> Field:
    """Analyze what was read, and return its direction field; does not touch Blender.

    Raises
    ------
    CurvatureError
        If the mesh cannot be analyzed, or the spacing does not suit it.
    """
    subject = reading.analyzed(part_of(on_progress, 0.0, _ANALYSIS))
    analysis = subject.analysis
    panel_size = criterion_of(subject, plan.panel).tolerance.panel_size
    sizes = resolve_sizes(plan.lines, panel_size, analysis.surface.mesh.diagonal)
    length = plan.lines.smoothing_length
    key = f"{subject.fingerprint} {length:g}"
    lines = cache.find_field(key)
    if lines is None:
        lines = build_line_field(analysis.surface, analysis.curvature, length or None)
        cache.keep_field(key, lines)
    on_progress(1.0)
    return Field(subject, lines, sizes)


def cover(field: Field, families: tuple[Family, ...], on_progress: Progress) -> CurvatureLines:
    """Return evenly spaced lines of some families.

    Raises
    ------
    InvalidSettingError
        If the spacing is far finer than the model.
    """
    spacing = field.sizes.spacing
    check_resolution(spacing, field.lines.field.mesh.edge_length)
    return trace_evenly(field.lines, spacing, families, on_progress)
