# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writing the table of wheels, tools/locks/wheels.toml, from `wheel_sources`."""

from __future__ import annotations

import json
import tempfile
from pathlib import Path

from . import environments, repack, wheels
from .console import step
from .wheel_sources import SOURCES, WheelSource

_HEADER = """\
# Written by dev.py lock: the wheels that the zips carry, with the hash of each file.
# Where `repacked` is given, that file is made from the original by tools/repack.py and shipped.
"""


def write_table() -> None:
    """Download every wheel once and write down its name and hash."""
    python = environments.ensure("geometry")
    rows = []
    for source in SOURCES:
        for platform in source.platforms:
            with step(f"hashing {source.requirement} for {source.pythons[0]} on {platform}"):
                rows.append(_row(python, source, platform))
    wheels.TABLE.write_text(_HEADER + "".join(rows), encoding="utf-8")


def _row(python: Path, source: WheelSource, platform: str) -> str:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        original = wheels.download(python, folder, source.requirement, source.pythons[0], platform)
        row: dict[str, object] = {
            "file": original.name,
            "sha256": wheels.sha256(original),
            "requirement": source.requirement,
            "pythons": source.pythons,
            "platform": platform,
        }
        if repack.is_repacked(source.requirement):
            repacked = repack.repack(original, folder / "repacked")
            row |= {"repacked": repacked.name, "repacked_sha256": wheels.sha256(repacked)}
    # Strings and lists of strings are written alike in JSON and TOML.
    return "\n[[wheel]]\n" + "".join(f"{key} = {json.dumps(value)}\n" for key, value in row.items())
