# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature lines and umbilics on the page of a report."""

from __future__ import annotations

from typing import Any

from .html_parts import table

_LINE_NAMES = {"curvature_lines": "Curvature lines", "asymptotic_lines": "Asymptotic lines"}


def findings_section(block: dict[str, Any]) -> str:
    """Return the tables of an object's lines and umbilics, empty where there are none."""
    parts = [
        _lines(name, block[key]) for key, name in _LINE_NAMES.items() if block.get(key) is not None
    ]
    if block.get("umbilics") or block.get("umbilic_areas"):
        parts.append(_umbilics(block))
    return "\n".join(parts)


def _lines(name: str, found: dict[str, Any]) -> str:
    families = {key: each for key, each in found.items() if key.startswith("family_")}
    rows = [
        (
            key.replace("_", " ").capitalize(),
            f"{each['count']:,}",
            f"{each['length']:.4g}",
            f"{max((line['length'] for line in each['lines']), default=0.0):.4g}",
        )
        for key, each in families.items()
    ]
    note = (
        f"<p class='faint'>{found['spacing']:.4g} m apart; at most "
        f"{1000.0 * found['deviation']:.2g} mm from the surface</p>"
    )
    heads = ("Family", "Lines", "Length (m)", "Longest (m)")
    return f"<h3>{name}</h3>" + table(heads, rows) + note


def _umbilics(block: dict[str, Any]) -> str:
    rows = [
        (
            str(number),
            *(f"{value:.4g}" for value in umbilic["position"]),
            f"{umbilic['index']:+g}",
            umbilic["kind"].capitalize(),
        )
        for number, umbilic in enumerate(block.get("umbilics", ()), 1)
    ]
    rows += [
        (f"Area of {area['area']:.4g} m²", "", "", "", f"{area['index']:+g}", "")
        for area in block.get("umbilic_areas", ())
    ]
    heads = ("Umbilic", "x (m)", "y (m)", "z (m)", "Index", "Kind")
    return "<h3>Umbilics</h3>" + table(heads, rows)
