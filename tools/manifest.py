# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension's manifest: read from the root, derived for a series of Blenders, written."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from .places import ROOT

FILE_NAME = "blender_manifest.toml"
WHEELS_FOLDER = "wheels"


def read_manifest(path: Path = ROOT / FILE_NAME) -> dict[str, Any]:
    """Return a manifest as Python values."""
    return tomllib.loads(path.read_text(encoding="utf-8"))


def derive_manifest(
    root: Mapping[str, Any],
    *,
    blender_min: str,
    blender_max: str | None,
    platforms: Sequence[str],
    wheel_names: Sequence[str],
) -> dict[str, Any]:
    """Return the manifest of one series of Blender versions.

    Parameters
    ----------
    root : mapping
        The manifest at the root of the repository; what is not named below stays as it is there.
    blender_min, blender_max : str
        The first Blender version of the series and the first one after it; None if it is open.
    platforms : sequence of str
        Blender's names of the platforms to build for.
    wheel_names : sequence of str
        File names of the wheels, which lie in the folder `wheels`.
    """
    derived = dict(root)
    derived["blender_version_min"] = blender_min
    derived.pop("blender_version_max", None)
    if blender_max:
        derived["blender_version_max"] = blender_max
    derived["platforms"] = list(platforms)
    derived["wheels"] = [f"./{WHEELS_FOLDER}/{name}" for name in wheel_names]
    return derived


def write_manifest(manifest: Mapping[str, Any], path: Path) -> None:
    """Write a manifest: strings, lists of strings, and tables of these."""
    tables = {key: value for key, value in manifest.items() if isinstance(value, Mapping)}
    lines = [_line(key, value) for key, value in manifest.items() if key not in tables]
    for name, table in tables.items():
        lines += ["", f"[{name}]", *(_line(key, value) for key, value in table.items())]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


def _line(key: str, value: str | list[str]) -> str:
    # Strings and lists of strings are written alike in JSON and TOML.
    return f"{key} = {json.dumps(value, ensure_ascii=False)}"
