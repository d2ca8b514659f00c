# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is unsound about a surface, in words and counts that a designer can act on."""

from __future__ import annotations

import numpy as np

from .libigl import misoriented_triangles
from .surface import Surface

#: Rounding above this share of the median edge length spoils curvature visibly.
_COARSE_ROUNDING = 1e-4
#: About how many edges are measured for it.
_SAMPLE = 10_000

#: More sharp marks than this share of the edges nobody sets by hand.
_SHADED_SHARE = 0.25


def diagnose(surface: Surface) -> tuple[str, ...]:
    """Return one sentence per kind of defect, each with the number of places.

    Parameters
    ----------
    surface : Surface

    Returns
    -------
    tuple of str
        Empty for a sound surface.
    """
    mesh, edges = surface.mesh, surface.edges
    counted = (
        (
            int(surface.is_degenerate.sum()),
            "face has no area and gets no class: Mesh > Clean Up > Degenerate Dissolve",
            "faces have no area and get no class: Mesh > Clean Up > Degenerate Dissolve",
        ),
        (
            duplicate_polygon_count(surface),
            "face repeats another one and counts twice: Mesh > Clean Up > Merge by Distance",
            "faces repeat others and count twice: Mesh > Clean Up > Merge by Distance",
        ),
        (
            edges.nonmanifold_count,
            "edge has more than two faces and counts as a crease: delete inner faces",
            "edges have more than two faces and count as creases: delete inner faces",
        ),
        (
            edges.flipped_count,
            f"edge has faces that point to opposite sides and counts as a crease{_cure(surface)}",
            f"edges have faces that point to opposite sides and count as creases{_cure(surface)}",
        ),
        (
            int((np.bincount(mesh.corner_vertex, minlength=mesh.vertex_count) == 0).sum()),
            "vertex has no faces and no curvature",
            "vertices have no faces and no curvature",
        ),
    )
    sentences = [f"{count} {one if count == 1 else many}" for count, one, many in counted if count]
    return (*sentences, *_shading_warning(surface), *_rounding_warning(surface))


def duplicate_polygon_count(surface: Surface) -> int:
    """Return the number of polygons that have the same set of vertices as an earlier one."""
    mesh = surface.mesh
    # The sum of well mixed numbers, one per vertex, names a set of vertices whatever their order.
    mixed = (mesh.corner_vertex.astype(np.uint64) + np.uint64(1)) * np.uint64(0x9E3779B97F4A7C15)
    mixed ^= mixed >> np.uint64(31)
    mixed *= np.uint64(0xBF58476D1CE4E5B9)
    mixed ^= mixed >> np.uint64(29)
    sums = np.sort(np.add.reduceat(mixed, mesh.polygon_start[:-1]))
    return int(np.count_nonzero(sums[1:] == sums[:-1]))


def _shading_warning(surface: Surface) -> tuple[str, ...]:
    """Warn of sharp edges that come from shading: importers mark them on models shaded flat."""
    edges = surface.edges
    if edges.marked_count <= _SHADED_SHARE * len(edges.inner):
        return ()
    return (
        f"{edges.marked_count} of {len(edges.inner)} edges are creases only because they are "
        "marked sharp, which leaves flat facets: if that is the shading of an import, "
        "Edge > Clear Sharp",
    )


def _cure(surface: Surface) -> str:
    """Return what would mend faces that point to opposite sides, empty where none do."""
    if not surface.edges.flipped_count:
        return ""
    mesh = surface.mesh
    is_turned = misoriented_triangles(mesh.corner_vertex[mesh.triangle_corner])
    count = len(np.unique(mesh.triangle_polygon[is_turned]))
    faces = "1 face" if count == 1 else f"{count} faces"
    return f" ({faces} to turn): Mesh > Normals > Recalculate Outside"


def _rounding_warning(surface: Surface) -> tuple[str, ...]:
    mesh = surface.mesh
    # Some thousand edges tell the median well enough for a warning.
    step = len(mesh.corner_vertex) // _SAMPLE + 1
    end = mesh.next_corner[::step]
    side = mesh.vertices[mesh.corner_vertex[end]] - mesh.vertices[mesh.corner_vertex[::step]]
    lengths = np.sort(np.linalg.norm(side, axis=1))
    median = lengths[len(lengths) // 2]
    if mesh.resolution <= _COARSE_ROUNDING * median:
        return ()
    return (
        f"coordinates are so far from the origin that they are rounded to "
        f"{mesh.resolution:.2g} m: move the geometry to the origin of the object and model again",
    )
