# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Labels: the class of every polygon, as few and clean areas as the evidence allows."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..classification import SurfaceClass
from ..criterion import Criterion, classify_by
from ..curvature import Curvature
from ..links import smooth_links
from ..surface import Surface
from ..types import AnyArray, Flags, Floats, Indices, Progress
from .likelihood import class_costs
from .piece_evidence import PieceCosts
from .potts import Flows, PottsProblem, minimize_potts
from .seams import NO_MODEL, find_seams

#: Length of border, in panels, that is worth as much as one unit of evidence on a panel's area.
_STIFFNESS = 0.2

#: The scale of decisions is a panel, but no less than this many edges: else nothing is smoothed.
_LEAST_EDGES = 2.0

#: What blurred curvature counts where positions are heard.
_BLURRED = 2.0


@dataclass(frozen=True)
class FaceCurvature:
    """Curvature of the polygons, with its uncertainty.

    Parameters
    ----------
    k1, k2 : (m,) float64
        In 1/m.
    uncertainty : (m,) float64
        Standard deviation of k1 and k2 in 1/m.
    is_defined : (m,) bool
    """

    k1: Floats
    k2: Floats
    uncertainty: Floats
    is_defined: Flags


@dataclass(frozen=True)
class Labeling:
    """What the class of every polygon is found from, as more becomes known.

    The energy is the negative logarithm of the probability of the labels per panel area, plus a
    price per length of border; borders along creases are free. What is certain keeps its class,
    however narrow; what is uncertain joins its surroundings.

    Parameters
    ----------
    cost : (m, 4) float64
        Of every class, by curvature and positions near seams.
    area : (m,) float64
    is_defined : (m,) bool
    links : (q, 2) int64
        Neighbors that are both defined.
    weight : (q,) float64
        Price of a border between them.
    fixed : (m,) int64 or None
        Classes given by the user; -1 where free.
    flows : list of pairs of arrays
        What the next labels are found faster from, as they differ little.
    """

    cost: Floats
    area: Floats
    is_defined: Flags
    links: Indices
    weight: Floats
    fixed: Indices | None
    flows: Flows = field(default_factory=list[tuple[AnyArray, AnyArray]])

    @staticmethod
    def of(
        surface: Surface,
        faces: FaceCurvature,
        criterion: Criterion,
        evidence: tuple[Floats, Flags],
        fixed: Indices | None = None,
    ) -> Labeling:
        """Return the labeling of a surface's polygons.

        Parameters
        ----------
        surface : Surface
        faces : FaceCurvature
        criterion : Criterion
            What is smaller than its panel, and doubtful, is not worth a border.
        evidence : pair of (m, 4) float64 and (m,) bool
            Costs of the classes by position, and the polygons where it is heard.
        fixed : (m,) int64, optional
            Classes given by the user; -1 where free.
        """
        cost = class_costs(faces.k1, faces.k2, faces.uncertainty, criterion)
        # Near a seam curvature is blurred, and positions know better; it only breaks ties, and
        # speaks for the classes that no position can speak for.
        position_cost, is_heard = evidence
        own, position_cost = cost[is_heard], position_cost[is_heard]
        has_model = position_cost != NO_MODEL
        cost[is_heard] = position_cost + np.where(has_model, np.minimum(own, _BLURRED), own)
        links, length = smooth_links(surface)
        known = faces.is_defined[links[:, 0]] & faces.is_defined[links[:, 1]]
        links, length = links[known], length[known]
        panel = max(criterion.tolerance.panel_size, _LEAST_EDGES * _typical_edge(length))
        return Labeling(
            cost=cost,
            area=surface.polygon_area,
            is_defined=faces.is_defined,
            links=links,
            weight=_STIFFNESS * panel * length,
            fixed=fixed,
        )

    def labels(
        self,
        on_progress: Progress | None = None,
        on_pieces: PieceCosts | None = None,
    ) -> Indices:
        """Return the class of every polygon: the labels of least energy.

        Parameters
        ----------
        on_progress : callable, optional
            Receives the share of the work that is done.
        on_pieces : PieceCosts, optional

        Returns
        -------
        (m,) int64
            Values of `SurfaceClass`; undefined polygons stay undefined.
        """
        cost = self.cost
        if on_pieces is not None:
            # Either a polygon lies on a piece, or on what no primitive describes.
            cost = on_pieces.combined(cost)
        problem = PottsProblem(
            cost=np.where(self.is_defined[:, None], cost, 0.0) * self.area[:, None],
            links=self.links,
            weight=self.weight,
        )
        labels = minimize_potts(problem, self.fixed, on_progress, self.flows)
        return np.where(
            self.is_defined | (False if self.fixed is None else self.fixed >= 0),
            labels,
            SurfaceClass.UNDEFINED,
        ).astype(np.int64)


def seam_evidence(
    surface: Surface, links: Indices, curvature: Curvature, criterion: Criterion
) -> tuple[Floats, Floats, tuple[Floats, Flags]]:
    """Return what positions near seams say about the polygons.

    Parameters
    ----------
    surface : Surface
    links : (p, 2) int64
        Of the surface's sectors.
    curvature : Curvature
    criterion : Criterion

    Returns
    -------
    k1, k2 : (s,) float64
        Curvatures of the sectors that jump at seams.
    evidence : pair of (m, 4) float64 and (m,) bool
        Costs of the classes, and the polygons where positions tell something.
    """
    position = surface.sector_position
    place_class = classify_by(curvature.k1, curvature.k2, criterion, curvature.is_defined)
    seams = find_seams(position, links, curvature, place_class, criterion.curvature_limit)
    sector, start = surface.corner_sector, surface.mesh.polygon_start[:-1]
    # A polygon lies on a surface only if all its corners do; those on the seam lie on both.
    cost = np.maximum.reduceat(
        np.where(seams.is_doubtful[sector, None], seams.cost[sector], 0.0), start, axis=0
    )
    is_heard = np.logical_or.reduceat(seams.has_evidence[sector], start)
    is_heard &= cost.min(axis=1) < NO_MODEL
    return seams.k1, seams.k2, (cost, is_heard)


def class_of_sectors(surface: Surface, face_class: Indices) -> Indices:
    """Return the class of all polygons at a sector, -1 where they differ or have none."""
    label = face_class[surface.mesh.corner_polygon]
    order = np.argsort(surface.corner_sector, kind="stable")
    sorted_label = label[order]
    first = np.searchsorted(surface.corner_sector[order], np.arange(surface.sector_count))
    low = np.minimum.reduceat(sorted_label, first)
    high = np.maximum.reduceat(sorted_label, first)
    return np.where(low == high, low, -1)


def _typical_edge(length: Floats) -> float:
    return float(np.median(length)) if len(length) else 0.0
