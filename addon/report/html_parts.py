# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of the HTML report that know nothing of curvature but their numbers: style and drawings."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

STYLE = """
:root{color-scheme:light}
body{margin:0;background:#f5f5f3;color:#222;font:15px/1.5 system-ui,'Segoe UI',Helvetica,sans-serif}
main{max-width:1080px;margin:0 auto;padding:32px 24px 64px}
h1{font-size:28px;margin:0 0 4px}h2{font-size:21px;margin:0 0 4px}
h3{font-size:16px;margin:28px 0 6px}
section{background:#fff;border:1px solid #e2e2de;border-radius:8px;padding:20px 24px;margin:20px 0}
.pictures{display:grid;grid-template-columns:1fr 1fr;gap:14px;padding:14px}
figure{margin:0}figure img{width:100%;border-radius:4px;display:block}
figcaption{color:#666;font-size:13px;margin-top:4px}
.faint{color:#6a6a6a}.warning{background:#fff4d6;border-left:4px solid #e0a000;padding:6px 12px}
.bar{display:flex;height:22px;border-radius:4px;overflow:hidden;margin:14px 0;background:#eee}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}
th,td{padding:5px 10px;text-align:right;border-bottom:1px solid #ececea}
th{font-weight:600;color:#555;font-size:13px}
th:first-child,td:first-child{text-align:left}
.swatch{display:inline-block;width:13px;height:13px;border-radius:3px;margin-right:8px;
vertical-align:-1px;box-shadow:0 0 0 1px #0003}
.row{display:flex;gap:24px;flex-wrap:wrap;margin-top:20px}.row svg{flex:1 1 420px}
@media print{body{background:#fff}section{break-inside:avoid;border:0;padding:0}}
"""

HISTOGRAM_NOTE = (
    "Area by absolute curvature of the faces. Left of the line panels count as straight; "
    "the last bar holds all that bends more."
)

_WIDTH, _HEIGHT, _LEFT, _BOTTOM, _TOP = 480.0, 220.0, 46.0, 34.0, 26.0


def table(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return an HTML table; cells are HTML already, heads are text."""
    head = "".join(f"<th>{escape(text)}</th>" for text in heads)
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def histogram_svg(title: str, histogram: dict[str, Any], limit: float) -> str:
    """Return a histogram of curvature as SVG, with a line at the limit.

    Parameters
    ----------
    title : str
    histogram : dict
        `edges` of b + 1 bars in 1/m and `areas` of b bars in m².
    limit : float
        In 1/m.
    """
    edges, areas = histogram["edges"], histogram["areas"]
    total, highest = sum(areas) or 1.0, max([*areas, 1e-300])
    span = edges[-1] - edges[0] or 1.0
    plot_width, plot_height = _WIDTH - _LEFT - 10.0, _HEIGHT - _BOTTOM - _TOP

    def across(value: float) -> float:
        return _LEFT + plot_width * (value - edges[0]) / span

    bars = "".join(
        f"<rect x='{across(low):.1f}' y='{_TOP + plot_height * (1 - area / highest):.1f}' "
        f"width='{max(across(high) - across(low) - 1.0, 0.5):.1f}' "
        f"height='{plot_height * area / highest:.1f}' fill='#7d93a8'>"
        f"<title>{low:.3g} to {high:.3g} 1/m: {100 * area / total:.1f} %</title></rect>"
        for low, high, area in zip(edges, edges[1:], areas, strict=False)
    )
    ground = _TOP + plot_height
    marks = "".join(
        f"<text x='{across(value):.1f}' y='{ground + 15:.1f}' text-anchor='middle'>"
        f"{value:.3g}</text>"
        for value in (edges[0] + span * step / 4.0 for step in range(5))
    )
    line = (
        f"<line x1='{across(limit):.1f}' x2='{across(limit):.1f}' y1='{_TOP - 4:.1f}' "
        f"y2='{ground:.1f}' stroke='#c0392b' stroke-width='1.5'/>"
        f"<text x='{across(limit) + 5:.1f}' y='{_TOP + 6:.1f}' fill='#c0392b'>limit</text>"
    )
    return (
        f"<svg viewBox='0 0 {_WIDTH:g} {_HEIGHT:g}' font-size='11' fill='#555' role='img' "
        f"aria-label='{escape(title)}'>"
        f"<text x='{_LEFT:g}' y='14' font-size='13' fill='#222'>{escape(title)} (1/m)</text>"
        f"<text x='{_LEFT - 6:g}' y='{_TOP + 8:g}' text-anchor='end'>"
        f"{100 * highest / total:.0f} %</text>"
        f"<line x1='{_LEFT:g}' x2='{_WIDTH - 10:g}' y1='{ground:g}' y2='{ground:g}' stroke='#999'/>"
        f"{bars}{marks}{line}</svg>"
    )
