# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The presets in the repository are what their table says, and so is the guide."""

from __future__ import annotations

from pathlib import Path

import pytest

from tools import materials


def test_the_committed_presets_are_what_the_table_makes(repository: Path) -> None:
    assets = repository / "assets"
    files = materials.preset_files()
    found = {path.relative_to(assets).as_posix() for path in assets.glob("presets/**/*.py")}
    assert found == set(files)
    for name, text in files.items():
        assert (assets / name).read_bytes() == text.encode(), f"{name}: run dev.py presets"


def test_writing_leaves_no_stale_presets(tmp_path: Path) -> None:
    first = materials.write(tmp_path)
    (first[0].parent / "Unobtainium.py").write_text("", encoding="utf-8")
    assert sorted(materials.write(tmp_path)) == sorted(first[0].parent.iterdir())


def test_names_can_be_names_of_files_everywhere() -> None:
    names = [material.name for material in materials.MATERIALS]
    assert len({name.lower() for name in names}) == len(names)
    for name in names:
        assert len(name) <= 63
        assert name.isascii()
        assert not set(name) & set('<>:"/\\|?*_')


@pytest.mark.parametrize("material", materials.MATERIALS, ids=lambda material: material.name)
def test_every_number_has_a_source_or_is_an_example(material: materials.Material) -> None:
    is_example = "(Example)" in material.name
    assert is_example == material.source.startswith("Example without a source")
    assert 0.01 < material.smallest_radius < 100.0


def test_the_guide_lists_every_material(repository: Path) -> None:
    guide = (repository / "docs" / "materials.md").read_text(encoding="utf-8")
    assert guide == materials.guide_text(), "run dev.py presets"
