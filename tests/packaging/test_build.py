# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The build leaves developers' files out and gives the same zip for the same files."""

import os
import zipfile
from pathlib import Path

from tools import build, manifest


def test_staged_copy_has_what_ships_and_no_more(tmp_path: Path) -> None:
    patterns = manifest.read_manifest()["build"]["paths_exclude_pattern"]
    build._stage(tmp_path / "staged", patterns)
    staged = {path.name for path in (tmp_path / "staged").iterdir()}
    assert {"__init__.py", "addon", "operators", "assets", "LICENSE"} <= staged
    assert not staged & {"tests", "tools", "docs", "dev.py", "dist", "out", ".git", ".ci"}
    assert not list((tmp_path / "staged").rglob("__pycache__"))


def test_zip_depends_on_names_and_content_only(tmp_path: Path) -> None:
    results = []
    for number, names in enumerate((["b.py", "a.py"], ["a.py", "b.py"])):
        built, even = tmp_path / f"built{number}.zip", tmp_path / f"even{number}.zip"
        with zipfile.ZipFile(built, "w", zipfile.ZIP_DEFLATED) as packed:
            for name in names:
                packed.writestr(zipfile.ZipInfo(name, (2020 + number, 1, 1, 0, 0, 0)), name * 9)
        build._even_out(built, even)
        results.append(even.read_bytes())
    assert results[0] == results[1]


def test_exclude_patterns_name_every_developers_file_at_the_root(repository: Path) -> None:
    """A new file at the root ships unless the manifest says otherwise: then this test asks."""
    patterns = manifest.read_manifest()["build"]["paths_exclude_pattern"]
    excluded = {pattern.strip("/") for pattern in patterns if pattern.startswith("/")}
    shipped = {"__init__.py", "blender_manifest.toml", "addon", "operators", "assets"}
    texts = {"README.md", "CHANGELOG.md", "LICENSE"}
    present = {name for name in os.listdir(repository) if not name.startswith((".", "__pycache__"))}
    assert present <= excluded | shipped | texts
