# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The manifest at the root agrees with the tables of Blenders and wheels, and derives well."""

import re
from pathlib import Path

import pytest

from tools import inspection, manifest, wheels
from tools.blenders import BLENDERS, PLATFORMS, SERIES, Series


@pytest.fixture(scope="module")
def root_manifest() -> dict:
    return manifest.read_manifest()


def test_wheels_are_those_of_the_table_for_the_first_series(root_manifest: dict) -> None:
    expected = {
        f"./wheels/{wheel.shipped}"
        for platform in PLATFORMS
        for wheel in wheels.select(SERIES["42"].python, platform)
    }
    assert set(root_manifest["wheels"]) == expected
    assert len(root_manifest["wheels"]) == len(expected)


def test_range_and_platforms_are_those_of_the_first_series(root_manifest: dict) -> None:
    assert root_manifest["blender_version_min"] == SERIES["42"].blender_min
    assert root_manifest["blender_version_max"] == SERIES["42"].blender_max
    assert tuple(root_manifest["platforms"]) == PLATFORMS


def test_changelog_has_a_section_for_the_version(root_manifest: dict, repository: Path) -> None:
    changelog = (repository / "CHANGELOG.md").read_text(encoding="utf-8")
    heading = rf"^## \[?{re.escape(root_manifest['version'])}\]?(\s|$)"
    assert re.search(heading, changelog, re.MULTILINE)


def test_derived_manifest_survives_writing(root_manifest: dict, tmp_path: Path) -> None:
    derived = manifest.derive_manifest(
        root_manifest,
        blender_min="5.1.0",
        blender_max=None,
        platforms=["linux-x64"],
        wheel_names=["a-1-cp313-cp313-linux_x86_64.whl"],
    )
    path = tmp_path / "blender_manifest.toml"
    manifest.write_manifest(derived, path)
    assert manifest.read_manifest(path) == derived
    unchanged = root_manifest.keys() - {
        *("blender_version_min", "blender_version_max", "platforms", "wheels")
    }
    assert all(derived[key] == root_manifest[key] for key in unchanged)
    assert "blender_version_max" not in derived


def test_series_cover_every_tested_blender_without_overlap() -> None:
    first, second = SERIES["42"], SERIES["51"]
    assert first.blender_max == second.blender_min
    for blender in BLENDERS.values():
        belongs_to_first = tuple(map(int, blender.version.split("."))) < (5, 1)
        assert blender.series is (first if belongs_to_first else second)


@pytest.mark.parametrize("series", SERIES.values(), ids=lambda series: series.name)
@pytest.mark.parametrize("platform", PLATFORMS)
def test_every_platform_has_libigl_and_scipy_for_one_python(series: Series, platform: str) -> None:
    names = [wheel.shipped for wheel in wheels.select(series.python, platform)]
    assert sorted(name.split("-")[0] for name in names) == ["libigl", "scipy"]
    assert not list(inspection.find_mixed_pythons(names))
