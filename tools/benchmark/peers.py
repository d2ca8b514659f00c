# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Estimators under one signature; all follow our signs: k > 0 on a sphere with outward normals."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .engine import geometry

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
#: Either "K" and "H", or "k1", "k2" and "direction_1".
Result = dict[str, Array]

OURS = "this engine"
DEFAULT = "igl r=5 (default)"


def ours(positions: Array, triangles: Indices, rounding_step: float = 0.0) -> Result:
    """Return what the extension's engine finds, by its defaults."""
    estimate = geometry("engine.estimator").estimate_curvature(
        positions, triangles, rounding_step=rounding_step
    )
    return {"k1": estimate.k1, "k2": estimate.k2, "direction_1": estimate.direction_1}


def _igl_principal(radius: int) -> Callable[[Array, Indices], Result]:
    def run(positions: Array, triangles: Indices) -> Result:
        igl: Any = import_module("igl")

        faces = triangles.astype(np.int32)
        one, _, k1, k2, _ = igl.principal_curvature(positions, faces, radius, True)
        return {"k1": np.ravel(k1), "k2": np.ravel(k2), "direction_1": one}

    return run


def _igl_discrete(positions: Array, triangles: Indices) -> Result:
    igl: Any = import_module("igl")

    faces = triangles.astype(np.int32)
    mass = igl.massmatrix(positions, faces, igl.MASSMATRIX_TYPE_VORONOI).diagonal()
    gaussian = np.asarray(igl.gaussian_curvature(positions, faces)).ravel() / mass
    vector = -(igl.cotmatrix(positions, faces) @ positions) / mass[:, None]
    normals = igl.per_vertex_normals(positions, faces)
    return {"K": gaussian, "H": 0.5 * np.einsum("ij,ij->i", vector, normals)}


def _vtk(positions: Array, triangles: Indices) -> Result:
    pyvista: Any = import_module("pyvista")

    mesh = pyvista.PolyData.from_regular_faces(positions, triangles)
    return {"K": np.asarray(mesh.curvature("gaussian")), "H": np.asarray(mesh.curvature("mean"))}


def _meshlab(positions: Array, triangles: Indices) -> Result:
    pymeshlab: Any = import_module("pymeshlab")

    found: Result = {}
    # What it calls minimum and maximum are swapped in sign order.
    for name, color in (("k1", "Min Curvature"), ("k2", "Max Curvature")):
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(positions, triangles))
        meshes.compute_curvature_principal_directions_per_vertex(
            method="Quadric Fitting", autoclean=False, curvcolormethod=color
        )
        found[name] = meshes.current_mesh().vertex_scalar_array()
        found["direction_1"] = meshes.current_mesh().vertex_curvature_principal_dir2_matrix()
    return found


def _trimesh(positions: Array, triangles: Indices) -> Result:
    trimesh: Any = import_module("trimesh")

    mesh = trimesh.Trimesh(positions, triangles, process=False)
    side = positions[triangles] - positions[np.roll(triangles, 1, axis=1)]
    radius = float(np.linalg.norm(side, axis=2).mean())
    area = np.pi * radius**2
    curvature = trimesh.curvature
    return {
        "K": curvature.discrete_gaussian_curvature_measure(mesh, positions, radius) / area,
        "H": curvature.discrete_mean_curvature_measure(mesh, positions, radius) / area,
    }


METHODS: dict[str, Callable[[Array, Indices], Result]] = {
    OURS: ours,
    "igl r=2": _igl_principal(2),
    "igl r=3": _igl_principal(3),
    DEFAULT: _igl_principal(5),
    "igl discrete": _igl_discrete,
    "VTK": _vtk,
    "MeshLab": _meshlab,
    "trimesh": _trimesh,
}
#: The largest meshes for methods that are too slow beyond.
LIMIT = {"trimesh": 12_000, "igl r=3": 12_000, "MeshLab": 120_000}


def completed(result: Result) -> Result:
    """Return a result with all of k1, k2, K and H; what is not finite is zero."""
    found = dict(result)
    if "k1" in found:
        found["K"], found["H"] = found["k1"] * found["k2"], 0.5 * (found["k1"] + found["k2"])
    else:
        root = np.sqrt(np.maximum(found["H"] ** 2 - found["K"], 0.0))
        found["k1"], found["k2"] = found["H"] + root, found["H"] - root
    return {name: np.nan_to_num(values, posinf=0.0, neginf=0.0) for name, values in found.items()}
