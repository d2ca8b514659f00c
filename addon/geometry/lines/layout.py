# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines that cover a surface evenly: as far from each other as asked for, without holes.

First come the lines that run into umbilics, which part the others, and lines across which the
spacing can be measured off. Then gaps are filled from the lines beside them, and last what is still
far from any line.

References
----------
.. [1] Jobard, Lefer (1997). Creating evenly-spaced streamlines of arbitrary density. Visualization
       in Scientific Computing.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..errors import InvalidSettingError
from ..groups import sum_by_group
from ..types import Floats, Indices, Progress
from .assembly import assemble
from .continuing import continuing_seeds
from .endings import Rules, Surroundings, surroundings
from .field import PRINCIPAL, Family
from .guides import ACROSS, balance, guide_seeds, measured_seeds
from .holes import hole_seeds
from .lines import CurvatureLines, joined_lines, no_lines
from .samples import Samples, are_between, distances, joined, seed_samples
from .seeding import gap_seeds, ray_seeds, samples_along
from .seeds import Seeds
from .tracer import LineField, is_usable, usable
from .tracing import trace

#: Share of the spacing at which a line ends beside another one.
_NEAREST = 0.5
#: Share of that for lines that all close, at distances chosen so that they can.
_NEAREST_RING = 0.6
#: Seeds closer than this share of the spacing to a line are none.
_FREE = 0.85
#: Those that go on from a line are none where another one is this close.
_BESIDE = 0.2
#: Least number of lines across a guide from which to see how far apart they are.
_CROSSING = 12
#: Lines across a guide are on average as long as their part's area over the guide's length. Where
#: one is longer than this many times that, distances vary by more than `guides.balance` can make
#: up for: it ends there. Points left out may make it shorter again, but not below this share.
_LONGEST, _CUT = 3.0, 0.95
#: Shorter lines than this many spacings are left out; a tenth of it from rim to rim.
_SHORTEST = 1.0
#: The same in holes that would stay without.
_SHORTEST_IN_HOLE = 0.5
#: Most seams that lines go on beyond one after the other.
_SEAMS = 20
#: Most rounds of filling; gaps are gone much earlier.
_ROUNDS = 60


@dataclass
class _Layout:
    """Lines placed so far, their samples, and how many of them went on at seams.

    Of every shortest length, the seeds tried with it: of a longer line there may be no room where a
    shorter one still has some. Samples of lines that all close, between which none belongs.
    """

    lines: LineField
    rules: Rules
    around: Surroundings
    placed: CurvatureLines
    samples: Samples
    tried: dict[float, Samples]
    rings: Samples
    gone_on: int = 0

    def add(self, seeds: Seeds, shortest: float = _SHORTEST, rules: Rules | None = None) -> int:
        """Trace seeds against what is placed; return the number of new lines."""
        seeds = usable(self.lines, seeds)
        if not len(seeds):
            return 0
        rules = rules or self.rules
        spacing = rules.spacing
        field = self.lines.field
        state, samples = trace(field, self.around, seeds, self.samples, rules)
        new = assemble(field, state, samples, rules, shortest * spacing)
        # Who gave way to a line that is placed now may still have room beside it.
        is_told = (samples.arc == 0.0) & ~state.is_removed[samples.line]
        before = self.tried.get(shortest, self.lines.no_samples)
        self.tried[shortest] = joined([before, samples.chosen(is_told)])
        if new.count:
            self.samples = joined(
                [
                    self.samples,
                    samples_along(self.lines.field, new, 0.25 * spacing, self.placed.count),
                ]
            )
            self.placed = joined_lines(self.placed, new)
        return new.count

    def add_rings(self, seeds: Seeds) -> None:
        """Trace lines that all close, and leave the gaps between them as they are."""
        before = self.placed.count
        self.add(seeds, rules=replace(self.rules, tolerance=_NEAREST_RING))
        new = self.placed.chosen(np.arange(before, self.placed.count))
        step = 0.25 * self.rules.spacing
        found = samples_along(self.lines.field, new, step, before)
        self.rings = joined([self.rings, found.chosen(new.is_closed[found.line - before])])

    def go_on(self, families: tuple[Family, ...]) -> None:
        """Go on beyond seams from the lines that were not there the last time."""
        for _ in range(_SEAMS):
            new = self.placed.chosen(np.arange(self.gone_on, self.placed.count))
            self.gone_on = self.placed.count
            seeds = continuing_seeds(self.lines, new, families)
            if not self.add(self.fresh(seeds, _BESIDE)):
                break

    def fresh(self, seeds: Seeds, share: float = _FREE, shortest: float = _SHORTEST) -> Seeds:
        """Return the seeds that are a share of the spacing from lines, and not tried before."""
        tried = self.tried.get(shortest, self.lines.no_samples)
        found = seed_samples(self.lines.field, seeds)
        spacing = self.rules.spacing
        is_free = distances(found, self.samples, spacing, share * spacing) == np.inf
        is_free[is_free] = ~are_between(found.chosen(is_free), self.rings, spacing)
        is_new = distances(found, tried, spacing, 0.3 * spacing) == np.inf
        return seeds.chosen(is_free & is_new)


def trace_evenly(
    lines: LineField,
    spacing: float,
    families: tuple[Family, ...] = PRINCIPAL,
    on_progress: Progress | None = None,
) -> CurvatureLines:
    """Trace evenly spaced lines.

    Parameters
    ----------
    lines : LineField
    spacing : float
        Between neighboring lines of a family, in meters.
    families : tuple of Family
    on_progress : callable, optional
        Receives the share of the work that is done; may raise to stop it.

    Returns
    -------
    CurvatureLines
        Family by family, long lines first.

    Raises
    ------
    InvalidSettingError
        If the spacing is not a positive length.
    """
    if not (np.isfinite(spacing) and spacing > 0.0):
        raise InvalidSettingError(f"the spacing must be greater than zero, not {spacing:g} m")
    spacing = float(spacing)
    if on_progress:
        on_progress(0.0)
    layout = _Layout(
        lines=lines,
        rules=Rules(spacing=spacing, nearest=_NEAREST * spacing, competes=True),
        around=surroundings(lines.field, lines.umbilics, spacing),
        placed=no_lines(),
        samples=lines.no_samples,
        tried={},
        rings=lines.no_samples,
    )
    layout.add(ray_seeds(lines, families, spacing))
    seeds, piece = guide_seeds(lines, families)
    # The largest part first: lines go on from it into others.
    is_first = seeds.triangle == seeds.triangle[:1]
    for part in (is_first, ~is_first):
        guides = _alone(layout, seeds.chosen(part))
        scale, whole = _scales(layout, guides, piece, families)
        found = layout.fresh(measured_seeds(lines.field, guides, families, spacing, scale))
        is_ring = np.isin(_of_piece(piece[found.triangle], found.family), whole)
        layout.add_rings(found.chosen(is_ring))
        layout.add(found.chosen(~is_ring))
        layout.go_on(families)
    for turn in range(_ROUNDS):
        if on_progress:
            on_progress(1.0 - 0.8 ** (turn + 1))
        seeds = gap_seeds(lines, layout.placed, layout.samples, spacing)
        added = layout.add(layout.fresh(seeds))
        layout.go_on(families)
        if not added:
            seeds = hole_seeds(lines, layout.samples, families, spacing)
            seeds = layout.fresh(seeds, _FREE, _SHORTEST_IN_HOLE)
            if not len(seeds):
                break
            layout.add(seeds, _SHORTEST_IN_HOLE)
    return _sorted(layout.placed)


def _alone(layout: _Layout, seeds: Seeds, longest: Floats | None = None) -> CurvatureLines:
    """Return lines that end for themselves only, or at a length in meters, (n,)."""
    lines = layout.lines
    alone = Rules(layout.rules.spacing, layout.rules.nearest, competes=False)
    is_open = is_usable(lines, seeds.triangle, seeds.barycentric, seeds.family)
    seeds = seeds.chosen(is_open)
    longest = None if longest is None else longest[is_open]
    state, samples = trace(lines.field, layout.around, seeds, lines.no_samples, alone, longest)
    return assemble(lines.field, state, samples, alone, layout.rules.spacing)


def _scales(
    layout: _Layout, guides: CurvatureLines, piece: Indices, families: tuple[Family, ...]
) -> tuple[Floats, Indices]:
    """Return by how much to scale the distances along each guide, (g,) float64.

    That is 1 where lines come close to each other or drift apart anyway. Where they do neither by
    much, all can run from end to end, if they start closer where they are closest. Also which
    families of which pieces close then, all of their lines.
    """
    spacing = layout.rules.spacing
    scale = np.ones(guides.count)
    plain, seeds = (
        measured_seeds(layout.lines.field, guides, families, spacing, scale, fewest)
        for fewest in (1, _CROSSING)
    )
    across = np.array([int(ACROSS[Family(family)]) for family in guides.family], dtype=np.int64)
    own_piece = piece[guides.triangle[guides.start[:-1]]]
    own = _of_piece(own_piece, across)
    mesh = layout.lines.field.mesh
    area = sum_by_group(piece, 0.5 * mesh.double_area, int(piece.max(initial=-1)) + 1)
    longest = np.full(len(area) * (1 + max(Family)), np.inf)
    longest[own] = _LONGEST * area[own_piece] / guides.length
    number, all_of_them = (_of_piece(piece[each.triangle], each.family) for each in (plain, seeds))
    crossing = _alone(layout, seeds, longest[all_of_them])
    lines = _of_piece(piece[crossing.triangle[crossing.start[:-1]]], crossing.family)
    is_long = np.isin(own, lines[crossing.length > _CUT * longest[lines]])
    is_whole = np.zeros(guides.count, dtype=np.bool_)
    for guide in range(guides.count):
        count = int((number == own[guide]).sum())
        # A single line along a pipe has no neighbor to keep a distance from.
        if count > 1 and not is_long[guide]:
            share = count / int((all_of_them == own[guide]).sum())
            beside = crossing.chosen(np.flatnonzero(lines == own[guide]))
            scale[guide], is_whole[guide] = balance(layout.lines, beside, spacing, share)
    return scale, own[is_whole]


def _of_piece(piece: Indices, family: Indices) -> Indices:
    """Return a number for every family of every piece."""
    numbers: Indices = piece * (1 + max(Family)) + family
    return numbers


def _sorted(placed: CurvatureLines) -> CurvatureLines:
    """Return lines by family and falling length."""
    order: Indices = np.lexsort((-placed.length, placed.family))
    return placed.chosen(order)
