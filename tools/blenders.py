# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which Blenders the extension is built for and tested in.

Two series of zips come from one source, because Blender takes the union of the Python tags of all
wheels in a manifest and refuses a mixture (docs/packaging.md).
"""

from __future__ import annotations

from dataclasses import dataclass

PLATFORMS = ("linux-x64", "windows-x64", "macos-arm64", "macos-x64")


@dataclass(frozen=True)
class Series:
    """A range of Blender versions that share a CPython."""

    name: str
    python: str
    blender_min: str
    blender_max: str | None


@dataclass(frozen=True)
class Blender:
    """A Blender of which the bpy module is used for tests."""

    version: str
    bpy: str
    numpy: str
    series: Series

    @property
    def python(self) -> str:
        """The CPython that this Blender carries."""
        return self.series.python

    @property
    def environment(self) -> str:
        """The name of its environment, see `environments`."""
        return f"bpy-{self.version}"


SERIES = {
    "42": Series("42", python="3.11", blender_min="4.2.0", blender_max="5.1.0"),
    "51": Series("51", python="3.13", blender_min="5.1.0", blender_max=None),
}

# The numpy versions are those of the official builds; bpy's metadata would also take newer ones.
BLENDERS = {
    blender.version: blender
    for blender in (
        Blender("4.2", bpy="4.2.23", numpy="1.24.3", series=SERIES["42"]),
        Blender("4.5", bpy="4.5.15", numpy="1.26.4", series=SERIES["42"]),
        Blender("5.0", bpy="5.0.1", numpy="1.26.4", series=SERIES["42"]),
        Blender("5.2", bpy="5.2.3", numpy="2.3.4", series=SERIES["51"]),
    )
}

# An LTS that runs on Python 3.11, which Debian 12 has: nothing has to be built for the first test.
DEFAULT_BLENDER = BLENDERS["4.5"]
