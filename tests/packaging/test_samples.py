# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sample models in the repository are what their script makes."""

from __future__ import annotations

from pathlib import Path

from tools import samples


def test_the_committed_models_are_what_the_script_makes(repository: Path) -> None:
    folder = repository / "assets" / "models"
    texts = samples.sample_texts()
    assert {path.name for path in folder.iterdir()} == set(texts)
    for name, text in texts.items():
        assert (folder / name).read_bytes() == text.encode("ascii"), f"{name}: run dev.py samples"


def test_writing_twice_gives_the_same_bytes(tmp_path: Path) -> None:
    first = {path.name: path.read_bytes() for path in samples.write(tmp_path)}
    assert {path.name: path.read_bytes() for path in samples.write(tmp_path)} == first
