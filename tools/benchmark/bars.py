# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the engine promised to reach, beside what was measured."""

from __future__ import annotations

from collections.abc import Mapping

from .peers import OURS

_IRREGULAR = "irregular 4:1"
#: Kind of mesh, size, measure, and the largest error (of classes: the smallest share).
BARS: tuple[tuple[str, int, str, float], ...] = (
    ("regular", 10_000, "H", 5e-5),
    (_IRREGULAR, 1_000, "H", 1.7e-3),
    (_IRREGULAR, 10_000, "H", 1.5e-4),
    ("coarse 30×20", 1_000, "H", 1.2e-3),
    ("noise 0.1 %", 1_000, "H", 0.016),
    ("noise 0.1 %", 10_000, "H", 0.010),
    ("noise 1 %", 1_000, "H", 0.029),
    ("noise 1 %", 10_000, "H", 0.028),
    ("noise 1 %", 100_000, "H", 0.06),
    (_IRREGULAR, 1_000, "H rim", 0.02),
    (_IRREGULAR, 10_000, "H rim", 2e-3),
    ("noise 1 %", 10_000, "H rim", 0.05),
    (_IRREGULAR, 1_000, "directions", 0.12),
    (_IRREGULAR, 10_000, "directions", 0.012),
)
_CLASSES, _DEVELOPABLE = 99.0, 98.5
_CAD = 0.05

Table = Mapping[tuple[str, int, str], Mapping[str, float]]


def markdown(table: Table, cad_rows: Mapping[str, Mapping[str, tuple[float, float]]]) -> str:
    """Return the bars with what was measured; bars without a measurement are left out."""
    lines = ["| bar | at most | measured | |", "|---|---|---|---|"]
    for kind, size, measure, limit in BARS:
        value = table.get((kind, size, OURS), {}).get(measure)
        if value is not None:
            lines.append(
                f"| {measure}, {kind}, {size // 1000}k | {limit:.2g} | {value:.2g} "
                f"| {_verdict(value <= limit)} |"
            )
    for measure, least in (("classes", _CLASSES), ("classes developable", _DEVELOPABLE)):
        shares = {
            key: row[measure] for key, row in table.items() if key[2] == OURS and measure in row
        }
        if shares:
            (kind, size, _), value = min(shares.items(), key=lambda item: item[1])
            lines.append(
                f"| {measure}, worst row: {kind}, {size // 1000}k | at least {least:g} % "
                f"| {value:.2f} % | {_verdict(value >= least)} |"
            )
    worst = {name: row[OURS][0] for name, row in cad_rows.items() if OURS in row}
    if worst:
        name = max(worst, key=lambda key: worst[key])
        lines.append(
            f"| k1 of CAD meshes, worst row: {name} | {_CAD:g} | {worst[name]:.2g} "
            f"| {_verdict(worst[name] <= _CAD)} |"
        )
    return "\n".join(lines)


def _verdict(is_reached: bool) -> str:
    return "reached" if is_reached else "**missed**"
