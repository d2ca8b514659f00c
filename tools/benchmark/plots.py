# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the benchmarks: error against mesh size, time against mesh size."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module

from .peers import OURS
from .report import PICTURES

_RESOLUTION = 80


def errors(table: Mapping[tuple[str, int, str], Mapping[str, float]]) -> None:
    """Draw the error of H against the number of vertices, one panel per kind of mesh."""
    kinds = [kind for kind in dict.fromkeys(key[0] for key in table) if "coarse" not in kind]
    curves = {
        (kind, method): [
            (n, row["H"]) for (k, n, m), row in table.items() if (k, m) == (kind, method)
        ]
        for kind in kinds
        for method in dict.fromkeys(key[2] for key in table)
    }
    _draw(curves, kinds, "error of H / RMS curvature", "accuracy-error")


def times(curves: dict[tuple[str, str], list[tuple[int, float]]]) -> None:
    """Draw seconds against the number of vertices, one panel per kind of mesh."""
    kinds = list(dict.fromkeys(kind for kind, _ in curves))
    _draw(curves, kinds, "seconds", "accuracy-time")


def _draw(
    curves: dict[tuple[str, str], list[tuple[int, float]]], kinds: list[str], label: str, name: str
) -> None:
    import_module("matplotlib").use("Agg")
    plt = import_module("matplotlib.pyplot")
    columns = min(3, len(kinds))
    rows = -(-len(kinds) // columns)
    figure, axes = plt.subplots(
        rows, columns, figsize=(3.6 * columns, 3.0 * rows), sharex=True, sharey=True, squeeze=False
    )
    for axis, kind in zip(axes.ravel(), kinds, strict=False):
        for (of_kind, method), points in curves.items():
            if of_kind == kind and points:
                width = 2.5 if method == OURS else 1.0
                axis.loglog(*zip(*points, strict=True), "o-", ms=3, lw=width, label=method)
        axis.set_title(kind, fontsize=9)
        axis.grid(visible=True, alpha=0.3)
    for axis in axes[-1]:
        axis.set_xlabel("vertices")
    for row in axes:
        row[0].set_ylabel(label, fontsize=8)
    handles, labels = axes[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=len(labels), fontsize=8, frameon=False)
    figure.tight_layout(rect=(0.0, 0.05, 1.0, 1.0))
    PICTURES.mkdir(parents=True, exist_ok=True)
    figure.savefig(PICTURES / f"{name}.png", dpi=_RESOLUTION)
    print(f"wrote {PICTURES / name}.png")
