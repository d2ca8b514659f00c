# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of all estimators over surfaces, kinds of meshes and sizes."""

from __future__ import annotations

from . import bars, cad, plots, report
from .errors import MEASURES, averages, errors
from .meshes import KINDS, make, names
from .peers import LIMIT, METHODS, OURS, completed, ours

#: Averages by kind, size and method.
Table = dict[tuple[str, int, str], dict[str, float]]

_SIZES = (1_000, 10_000, 100_000)
_QUICK = (1_000, 4_000)
_SHOWN = ("H", "K", "k1", "k2", "H rim", "directions", "classes", "classes developable")


def run(*, quick: bool, held_out: bool, largest: int) -> None:
    """Measure, print, and write docs/accuracy.md and its plots unless it is a partial run."""
    sizes = [size for size in (_QUICK if quick else _SIZES) if not largest or size <= largest]
    methods = [OURS] if held_out else list(METHODS)
    if quick:
        methods = [
            name for name in methods if name in {OURS, "igl r=2", "igl r=5 (default)", "VTK"}
        ]
    table = measure(sizes, methods, held_out=held_out)
    rows = cad.measure([OURS] if quick or held_out else cad.SHOWN)
    print(cad.markdown(rows))
    print(bars.markdown(table, rows))
    if not (quick or held_out or largest):
        sections = {"bars": bars.markdown(table, rows), "cad": cad.markdown(rows)}
        for name in _SHOWN:
            sections[name] = markdown(table, name)
        report.write(sections)
        plots.errors(table)


def measure(sizes: list[int], methods: list[str], *, held_out: bool) -> Table:
    """Return the averages of all methods; a surface on which a method fails is left out, named."""
    table: Table = {}
    for kind in KINDS:
        for size in sizes[:1] if kind.startswith("coarse") else sizes:
            cases = [make(name, kind, size) for name in names(held_out=held_out)]
            for method in methods:
                if size > LIMIT.get(method, size):
                    continue
                rows = []
                for case in cases:
                    try:
                        if method == OURS and "float32" in kind:
                            step = float(2.0**-23 * abs(case.positions).max())
                            found = ours(case.positions, case.triangles, step)
                        else:
                            found = METHODS[method](case.positions, case.triangles)
                        rows.append(errors(case, completed(found)))
                    except Exception as error:  # noqa: BLE001 – a peer may raise anything; it is told
                        print(f"{method} fails on {case.name}, {kind}, {size}: {error}")
                table[kind, size, method] = averages(rows)
                cells = "  ".join(f"{n} {v:.2e}" for n, v in table[kind, size, method].items())
                print(f"{kind:24s} {size:7d} {method:18s} {cells}")
    return table


def markdown(table: Table, measure_name: str) -> str:
    """Return one measure as a table with a row per method."""
    columns = list(dict.fromkeys((kind, size) for kind, size, _ in table))
    methods = list(dict.fromkeys(method for _, _, method in table))
    lines = [
        f"| {MEASURES[measure_name]} | "
        + " | ".join(f"{k} {_short(s)}" for k, s in columns)
        + " |",
        "|---" * (len(columns) + 1) + "|",
    ]
    for method in methods:
        values = [table.get((*column, method), {}).get(measure_name) for column in columns]
        if any(value is not None for value in values):
            lines.append(
                f"| {method} | " + " | ".join(_cell(measure_name, v) for v in values) + " |"
            )
    return "\n".join(lines)


def _short(size: int) -> str:
    return f"{size // 1000}k"


def _cell(name: str, value: float | None) -> str:
    if value is None:
        return "–"
    return f"{value:.1f}" if "classes" in name else f"{value:.2g}"
