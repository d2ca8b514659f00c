# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Building the zips with Blender's own tool, from a staged copy with the manifest of one series."""

from __future__ import annotations

import os
import shutil
import tempfile
import zipfile
from collections.abc import Sequence
from pathlib import Path

from . import environments, inspection, wheels
from .blenders import DEFAULT_BLENDER, Series
from .console import step
from .manifest import FILE_NAME, WHEELS_FOLDER, derive_manifest, read_manifest, write_manifest
from .places import DIST, ROOT
from .platforms import current_platform
from .processes import python_environment, run_quietly

_DATE = (2026, 1, 1, 0, 0, 0)


def build(series: Series, platforms: Sequence[str]) -> list[Path]:
    """Build the zips of a series into dist/ and inspect them.

    Parameters
    ----------
    series : Series
        The range of Blender versions.
    platforms : sequence of str
        Blender's names of the platforms; one zip is built for each.

    Returns
    -------
    list of Path
        The zips, in the order of the platforms.

    Raises
    ------
    DevError
        If a wheel cannot be had, or Blender's tool or the inspection refuses a zip.
    """
    return _build(
        f"blender{series.name}", series.python, series.blender_min, series.blender_max, platforms
    )


def build_for_tests(python: str, blender: str) -> Path:
    """Build a zip for a Blender that was not built with an official Python, as Debian's are.

    Parameters
    ----------
    python : str
        The Python of that Blender, such as "3.13".
    blender : str
        Its version, such as "4.3"; the zip is for this version and newer ones.
    """
    name = f"test-blender{blender.replace('.', '')}-python{python.replace('.', '')}"
    return _build(name, python, f"{blender}.0", None, [current_platform()])[0]


def _build(
    name: str,
    python: str,
    blender_min: str,
    blender_max: str | None,
    platforms: Sequence[str],
) -> list[Path]:
    wanted = [wheel for platform in platforms for wheel in wheels.select(python, platform)]
    manifest = derive_manifest(
        read_manifest(),
        blender_min=blender_min,
        blender_max=blender_max,
        platforms=platforms,
        wheel_names=[wheel.shipped for wheel in wanted],
    )
    wheel_files = wheels.fetch(wanted)
    with (
        step(f"building {name} for {', '.join(platforms)}"),
        tempfile.TemporaryDirectory() as folder,
    ):
        source, output = Path(folder, "source"), Path(folder, "output")
        output.mkdir()
        _stage(source, manifest["build"]["paths_exclude_pattern"])
        (source / WHEELS_FOLDER).mkdir()
        for file in wheel_files:
            shutil.copyfile(file, source / WHEELS_FOLDER / file.name)
        write_manifest(manifest, source / FILE_NAME)
        blender_extension(
            *("build", "--split-platforms", "--source-dir", source, "--output-dir", output)
        )
        return [_collect(output, manifest, name, platform) for platform in platforms]


def _stage(target: Path, patterns: Sequence[str]) -> None:
    """Copy what ships; Blender's tool applies the same patterns, here it saves time."""
    anchored = {pattern.strip("/") for pattern in patterns if pattern.startswith("/")}
    loose = shutil.ignore_patterns(
        *(pattern.rstrip("/") for pattern in patterns if pattern[0] != "/")
    )

    def ignored(folder: str, names: list[str]) -> set[str]:
        return loose(folder, names) | (anchored & set(names) if Path(folder) == ROOT else set())

    shutil.copytree(ROOT, target, ignore=ignored)


def _collect(output: Path, manifest: dict[str, str], name: str, platform: str) -> Path:
    """Check a finished zip and put it into dist/, named by the Blenders that it is for."""
    stem = f"{manifest['id']}-{manifest['version']}"
    built = output / f"{stem}-{platform.replace('-', '_')}.zip"
    even = output / f"{stem}-{name}-{platform}.zip"
    _even_out(built, even)
    blender_extension("validate", even)
    inspection.inspect_zip(even)
    DIST.mkdir(exist_ok=True)
    final = DIST / even.name
    # Copied beside its place and renamed, so that nobody installs half a zip.
    partial = final.with_name(f".{final.name}.{os.getpid()}")
    shutil.copyfile(even, partial)
    partial.replace(final)
    return final


def _even_out(built: Path, even: Path) -> None:
    """Copy a zip with one date for all files and these in order: one commit gives one zip."""
    with zipfile.ZipFile(built) as source, zipfile.ZipFile(even, "w") as target:
        for entry in sorted(source.infolist(), key=lambda entry: entry.filename):
            copy = zipfile.ZipInfo(entry.filename, _DATE)
            copy.compress_type = entry.compress_type
            copy.create_system = 3  # Unix, wherever it is built
            copy.external_attr = 0o644 << 16
            target.writestr(copy, source.read(entry))


def blender_extension(*arguments: str | Path) -> str:
    """Run the command line tool for extensions that lies in Blender's scripts."""
    python = environments.ensure(DEFAULT_BLENDER.environment)
    scripts = environments.site_packages(python) / "bpy" / DEFAULT_BLENDER.version / "scripts"
    tool = scripts / "addons_core" / "bl_pkg" / "cli" / "blender_ext.py"
    return run_quietly(
        [python, tool, *arguments],
        f"Blender's tool for extensions refused to {arguments[0]}",
        environment=python_environment(),
    )
