# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The presets that ship: how far materials bend, with the source of every number.

`python3 dev.py presets` writes them into assets/presets. What has no source says that it is an
example; whoever knows better saves a preset of their own.
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from math import floor
from pathlib import Path

# By name: the package is called addon here, and otherwise where it is installed.
_TEXT = import_module("addon.preset_text")
_FOLDER = f"presets/{_TEXT.PRESET_FOLDER}"
_INCH = 0.0254
_FOOT = 0.3048


@dataclass(frozen=True)
class Material:
    """A sheet, the smallest radius in meters that it is bent to, and who says so."""

    name: str
    smallest_radius: float
    source: str


def _glass(millimeters: int) -> Material:
    return Material(
        f"Cold-bent Glass {millimeters} mm",
        1.5 * millimeters,
        "1500 × thickness, according to Sedak (transparence.lv); "
        "about 23 MPa by E t / 2R with E = 70 GPa",
    )


def _millimeters(inches: float) -> str:
    """Return a thickness with one decimal, halves rounded up as tables do."""
    return str(floor(254.0 * inches + 0.5) / 10.0)


def _plywood(thickness: str, inches: float, feet: tuple[int, int]) -> list[Material]:
    return [
        Material(
            f"Plywood {_millimeters(inches)} mm {grain.title()} Grain",
            round(radius * _FOOT, 4),
            f"APA, {thickness} in bent {grain} the grain to {radius} ft "
            "(Concrete Construction, Curving plywood forms)",
        )
        for grain, radius in zip(("across", "along"), feet, strict=True)
    ]


def _aircraft_plywood(inches: float, radii: tuple[float, float]) -> list[Material]:
    return [
        Material(
            f"Aircraft Plywood {_millimeters(inches)} mm {angle} Degrees",
            round(radius * _INCH, 4),
            f"FAA AC 43.13-1B, {inches:.3f} in bent dry on a cold mandrel to {radius:g} in, "
            f"axis at {angle} degrees to the face grain (engineersedge.com)",
        )
        for angle, radius in zip(("90", "0 to 45"), radii, strict=True)
    ]


def _composite(millimeters: int, radius: float) -> Material:
    return Material(
        f"Aluminum Composite {millimeters} mm",
        radius,
        "A supplier's rule of thumb, weak (aluxacp.com): ask the maker of the sheet",
    )


def _example(name: str, millimeters: int, factor: int, modulus: int) -> Material:
    """Return a metal sheet; its radius is where bending alone reaches a moderate stress."""
    return Material(
        f"{name} {millimeters} mm (Example)",
        factor * millimeters / 1000.0,
        f"Example without a source: {factor} × thickness, "
        f"about {1000 * modulus / (2 * factor):.0f} MPa by E t / 2R with E = {modulus} GPa; "
        "set the radius of your fabricator",
    )


MATERIALS = (
    *(_glass(millimeters) for millimeters in (6, 8, 10, 12)),
    *_plywood("1/4", 1 / 4, (2, 5)),
    *_plywood("5/16", 5 / 16, (2, 6)),
    *_plywood("3/8", 3 / 8, (3, 8)),
    *_plywood("1/2", 1 / 2, (6, 12)),
    *_plywood("5/8", 5 / 8, (8, 16)),
    *_plywood("3/4", 3 / 4, (12, 20)),
    *_aircraft_plywood(0.125, (12.0, 7.1)),
    *_aircraft_plywood(0.250, (31.0, 20.0)),
    *_aircraft_plywood(0.375, (54.0, 36.0)),
    _composite(3, 0.1),
    _composite(6, 0.2),
    *(_example("Aluminum Sheet", millimeters, 250, 70) for millimeters in (2, 3, 4)),
    *(_example("Steel Sheet", millimeters, 450, 210) for millimeters in (2, 3)),
)
"""In the order of the guide; Blender's menu sorts by name."""


_GUIDE = """# Material presets

What the menu *Presets* of the panel *Segmentation* offers; `python3 dev.py presets` writes
presets and this page from one table, `tools/materials.py`. A radius is the smallest that its
source bends the sheet to: whatever bends less than that counts as straight, because the flat
sheet takes it. **Example** marks what has no source: set the value of your fabricator, and save
it as a preset of your own by the button with the plus. Treat all of them as a start for a talk
with the fabricator: coatings, edges, grain, temper and fixings change them.

| preset | smallest radius m | source |
|---|---|---|"""


def preset_files() -> dict[str, str]:
    """Return the text of every preset by its path below assets."""
    return {
        f"{_FOLDER}/{material.name.replace(' ', '_')}.py": _TEXT.preset_text(
            "RADIUS",
            {"smallest_radius": material.smallest_radius},
            material.name,
            material.source,
        )
        for material in MATERIALS
    }


def guide_text() -> str:
    """Return the page of the guide with every material, its radius and its source."""
    rows = [
        f"| {material.name} | {material.smallest_radius:g} | {material.source} |"
        for material in MATERIALS
    ]
    return "\n".join((_GUIDE, *rows, ""))


def write(assets: Path) -> list[Path]:
    """Write the presets in place of those that are there, and return their paths."""
    folder = assets / _FOLDER
    folder.mkdir(parents=True, exist_ok=True)
    for stale in folder.glob("*.py"):
        stale.unlink()
    paths = []
    for name, text in preset_files().items():
        path = assets / name
        path.write_bytes(text.encode("utf-8"))
        paths.append(path)
    return paths
