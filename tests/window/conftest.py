# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plays scenarios in a windowed Blender and hands their pictures and records to the tests.

Runs inside the chroot that `python3 dev.py window` prepares: the zip, the sample models and the
harness lie beside this folder there.
"""

import json
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

_ROOT = Path(__file__).resolve().parents[2]
_SCENARIOS = Path(__file__).parent / "scenarios"

sys.path.append(str(_ROOT / "inside"))

import driver  # noqa: E402 - the harness lies there
from played import Played  # noqa: E402


@pytest.fixture(scope="session")
def models() -> Path:
    """The folder of the sample models."""
    return _ROOT / "assets" / "models"


@pytest.fixture(scope="session")
def user_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Blender's user folder with the extension installed from the zip and enabled."""
    folder = tmp_path_factory.mktemp("user")
    (_ROOT / "out").mkdir(exist_ok=True)
    driver.install(_ROOT / "extension.zip", folder, _ROOT / "out" / "install.log")
    return folder


@pytest.fixture(scope="session")
def play(user_folder: Path) -> Callable[..., Played]:
    """Play a scenario of the folder scenarios/ with arguments, once for all its tests."""
    records: dict[str, dict] = {}

    def play_once(name: str, *arguments: str) -> Played:
        folder = _ROOT / "out" / name
        if name not in records:
            folder.mkdir(parents=True)
            driver.play(_SCENARIOS / f"{name}.py", list(arguments), user_folder, folder)
            result = folder / "result.json"
            records[name] = (
                json.loads(result.read_text(encoding="utf-8"))
                if result.is_file()
                else {"error": "Blender ended early"}
            )
        log = (folder / "blender.log").read_text(encoding="utf-8", errors="replace")
        assert records[name]["error"] is None, f"{records[name]['error']}\n{log[-3000:]}"
        return Played(folder, records[name])

    return play_once
