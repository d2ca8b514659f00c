# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which wheels the extension ships: packages, versions and the platform tags to ask for.

`dev.py lock` turns this into the committed table tools/locks/wheels.toml.
"""

from __future__ import annotations

from dataclasses import dataclass

# pip's platform tags, the newest that Blender's own minimum systems allow. Blender ignores the
# version in a macOS or manylinux tag, so a too new one would only fail on the user's machine.
PIP_PLATFORMS = {
    "linux-x64": ("manylinux_2_28_x86_64", "manylinux2014_x86_64"),
    "windows-x64": ("win_amd64",),
    "macos-arm64": ("macosx_12_0_arm64",),
    "macos-x64": ("macosx_10_15_x86_64",),
}

# Debian's Blender 5.2 runs on this Python; test zips for it are built, nothing is released.
TEST_PYTHON = "3.14"


@dataclass(frozen=True)
class WheelSource:
    """A package in one version, for the Pythons that this version serves."""

    requirement: str
    pythons: tuple[str, ...]
    platforms: tuple[str, ...]


_EVERYWHERE = tuple(PIP_PLATFORMS)

SOURCES = (
    WheelSource("libigl==2.6.3", pythons=("3.11",), platforms=_EVERYWHERE),
    # One wheel with the stable ABI (cp312-abi3) serves Python 3.13 and 3.14.
    WheelSource("libigl==2.6.3", pythons=("3.13", TEST_PYTHON), platforms=_EVERYWHERE),
    # The last scipy that works with numpy 1.24 (Blender 4.2); it also works with numpy 2.3 (5.2).
    WheelSource("scipy==1.15.3", pythons=("3.11",), platforms=_EVERYWHERE),
    WheelSource("scipy==1.15.3", pythons=("3.13",), platforms=_EVERYWHERE),
    WheelSource("scipy==1.17.1", pythons=(TEST_PYTHON,), platforms=("linux-x64",)),
)
