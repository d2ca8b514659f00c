# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Developability: whether the rulings of single-curved areas are straight over a panel.

Zero Gaussian curvature at every vertex does not make a sheet single-curved: a crumpled sheet has
it too. What a single-curved panel needs is one direction along which the normal does not turn for
a panel's length. The normal turns along a direction r by dn = -II r, so that the normal curvature
along one fixed direction, II(r, r), must stay within the limit on the whole panel, not only at a
point. Averaging II r (x) II r over the panel's area gives the direction, averaging II(r, r)² the
verdict; both are averages of products of II, so no line is traced.
"""

from __future__ import annotations

import numpy as np

from ..classification import SurfaceClass
from ..curvature import Curvature
from ..groups import connected_groups, sum_by_group
from ..nearest import close_pairs
from ..surface import Surface
from ..types import Flags, Floats, Indices

#: Sides of the cells that a panel's window is made of, as a share of the panel.
_CELL = 0.25

#: A window holds the cells whose centers are this near, in panels: half a panel to each side.
_WINDOW = 0.5

#: A region with this share of its area in places where rulings turn by more than the limit is
#: crumpled. Sound regions stay below a quarter, seams and noise of 1 % of the edges included.
_CRUMPLED = 0.3

#: Polygons that smoothing reaches across a border.
_BLUR = 6


def ruling_deviation(
    surface: Surface, curvature: Curvature, face_class: Indices, panel_size: float
) -> Floats:
    """Return how far rulings are from straight, as a curvature to compare with the limit.

    Parameters
    ----------
    surface : Surface
    curvature : Curvature
        On the sectors.
    face_class : (m,) int64
        Windows never leave their connected single-curved region.
    panel_size : float
        In meters.

    Returns
    -------
    (m,) float64
        Root mean square over a panel around the polygon of the normal curvature along the panel's
        best ruling, in 1/m; zero for polygons of other classes.
    """
    result = np.zeros(len(face_class))
    single = np.flatnonzero(face_class == SurfaceClass.SINGLE)
    if not len(single):
        return result
    mesh = surface.mesh
    links = mesh.corner_polygon[surface.edges.smooth]
    inside = (face_class[links] == SurfaceClass.SINGLE).all(axis=1)
    region = connected_groups(links[inside], len(face_class))[single]
    area = surface.polygon_area[single]
    center, form = _forms(surface, curvature, single)
    cell, count = _cells(center, region, _CELL * panel_size)

    cell_area = np.maximum(sum_by_group(cell, area, count), 1e-300)
    middle = _means(cell, center, area, count, cell_area)
    cell_region = np.empty(count, dtype=np.int64)
    cell_region[cell] = region
    # Products of up to four factors of II: (II r)(II r) and II(r, r)².
    square = np.einsum("mij,mjk->mik", form, form)
    flat = form.reshape(-1, 9)
    fourth = _means(
        cell, (flat[:, :, None] * flat[:, None, :]).reshape(-1, 81), area, count, cell_area
    )
    second = _means(cell, square.reshape(-1, 9), area, count, cell_area)
    # Regions far apart in a fourth coordinate keep windows within their region.
    lifted = np.c_[middle, cell_region * (10.0 * panel_size)]
    near = close_pairs(lifted, _WINDOW * panel_size)
    pairs = np.concatenate([near, near[:, ::-1], np.tile(np.arange(count)[:, None], 2)])
    total = sum_by_group(pairs[:, 0], cell_area[pairs[:, 1]], count)
    window_2 = _gather(pairs, second, cell_area, total)
    window_4 = _gather(pairs, fourth, cell_area, total)
    # The plane of the window: rulings are sought in it, not along the normal.
    normal = _means(cell, surface.polygon_vector[single], np.ones(len(single)), count, cell_area)
    normal = _gather(pairs, normal, cell_area, total)
    normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    scale = np.trace(window_2.reshape(-1, 3, 3), axis1=1, axis2=2) + 1e-300
    blocked = window_2.reshape(-1, 3, 3) + (
        10.0 * scale[:, None, None] * normal[:, :, None] * normal[:, None, :]
    )
    ruling = np.linalg.eigh(blocked)[1][:, :, 0]
    pair = np.einsum("ci,cj->cij", ruling, ruling).reshape(-1, 9)
    turn = np.einsum("ci,cij,cj->c", pair, window_4.reshape(-1, 9, 9), pair)
    result[single] = np.sqrt(np.maximum(turn, 0.0))[cell]
    return result


def reject_bent_rulings(
    surface: Surface,
    curvature: Curvature,
    face_class: Indices,
    panel_size: float,
    curvature_limit: float,
) -> Flags:
    """Return the single-curved polygons that no single-curved panel fits.

    Parameters
    ----------
    surface, curvature, face_class, panel_size
        As in `ruling_deviation`.
    curvature_limit : float
        In 1/m.

    Returns
    -------
    (m,) bool
        Nothing in regions where only a small share is in doubt: near seams and in noise the
        measure exceeds the limit on sound surfaces too. In regions that are not developable, all
        polygons whose ruling turns by more than the limit.
    """
    deviation = ruling_deviation(surface, curvature, face_class, panel_size)
    links = surface.mesh.corner_polygon[surface.edges.smooth]
    same = face_class[links[:, 0]] == face_class[links[:, 1]]
    region = connected_groups(links[same], len(face_class))
    # Smoothing blurs what lies across a border into the region, as far as a patch reaches.
    blurred = np.zeros(len(face_class), dtype=np.bool_)
    blurred[links[~same].reshape(-1)] = True
    for _ in range(_BLUR):
        blurred[links[blurred[links].any(axis=1)].reshape(-1)] = True
    start = surface.mesh.polygon_start[:-1]
    is_smoothed = np.logical_or.reduceat(curvature.is_smoothed[surface.corner_sector], start)
    area = surface.polygon_area * ~(blurred & is_smoothed)
    is_bent = deviation > curvature_limit
    total = sum_by_group(region, surface.polygon_area, len(face_class))
    seen = sum_by_group(region, area, len(face_class))
    bent = sum_by_group(region, area * is_bent, len(face_class))
    is_crumpled = (bent > _CRUMPLED * seen) & (seen > _CRUMPLED * total)
    return is_crumpled[region] & is_bent


def _forms(surface: Surface, curvature: Curvature, faces: Indices) -> tuple[Floats, Floats]:
    """Return centers and second fundamental forms (symmetric tensors in space) of polygons."""
    mesh = surface.mesh
    size = np.diff(mesh.polygon_start)
    starts, wanted = mesh.polygon_start[:-1][faces], size[faces]
    row = np.repeat(np.arange(len(faces)), wanted)
    corner = np.arange(len(row)) - np.repeat(np.cumsum(wanted) - wanted, wanted) + starts[row]
    sector = surface.corner_sector[corner]
    weight = 1.0 / wanted[row]
    center = np.stack(
        [
            sum_by_group(row, weight * surface.sector_position[sector, axis], len(faces))
            for axis in range(3)
        ],
        axis=1,
    )
    k = (curvature.k1[sector], curvature.k2[sector])
    direction = (curvature.direction_1[sector], curvature.direction_2[sector])
    form = np.empty((len(faces), 3, 3))
    for i in range(3):
        for j in range(i, 3):
            value = sum(k[n] * direction[n][:, i] * direction[n][:, j] for n in range(2))
            form[:, i, j] = form[:, j, i] = sum_by_group(row, weight * value, len(faces))
    return center, form


def _cells(center: Floats, region: Indices, side: float) -> tuple[Indices, int]:
    """Return the cell of every polygon: a cube of space within one region."""
    box = np.floor((center - center.min(axis=0)) / side).astype(np.int64)
    order = np.lexsort((box[:, 2], box[:, 1], box[:, 0], region))
    ordered = np.c_[region, box][order]
    is_new = np.append(True, (ordered[1:] != ordered[:-1]).any(axis=1))
    cell = np.empty(len(order), dtype=np.int64)
    cell[order] = np.cumsum(is_new) - 1
    return cell, int(is_new.sum())


def _means(cell: Indices, values: Floats, weight: Floats, count: int, total: Floats) -> Floats:
    columns = [sum_by_group(cell, weight * column, count) for column in values.T]
    return np.stack(columns, axis=1) / total[:, None]


def _gather(pairs: Indices, values: Floats, weight: Floats, total: Floats) -> Floats:
    """Return the weighted mean of the cells' values over every cell's window."""
    from scipy.sparse import coo_array

    matrix = coo_array(
        (weight[pairs[:, 1]] / total[pairs[:, 0]], (pairs[:, 0], pairs[:, 1])),
        shape=(len(values), len(values)),
    ).tocsr()
    return np.asarray(matrix @ values, dtype=np.float64)
