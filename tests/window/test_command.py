# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""`blender --command curvature` as scripts call it, in a real Blender."""

import json
import os
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

Run = Callable[..., subprocess.CompletedProcess[str]]


@pytest.fixture
def run(user_folder: Path, tmp_path: Path) -> Run:
    def run(*arguments: object) -> subprocess.CompletedProcess[str]:
        command = ["blender", "--command", "curvature", *map(str, arguments)]
        environment = os.environ | {"BLENDER_USER_RESOURCES": str(user_folder)}
        return subprocess.run(  # noqa: S603 - our own command in the chroot
            command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
        )

    return run


def test_results_on_stdout_are_one_line_per_object(run: Run, models: Path) -> None:
    done = run("segment", models / "torus.obj")
    assert done.returncode == 0, done.stderr
    assert done.stdout.count("\n") == 1
    assert done.stdout.startswith("torus.obj: torus: ")


def test_json_on_stdout_is_nothing_but_json(run: Run, models: Path) -> None:
    done = run("segment", models / "torus.obj", "--json", "--quiet")
    assert json.loads(done.stdout)["objects"][0]["name"] == "torus"


def test_all_outputs_are_written(run: Run, models: Path, tmp_path: Path) -> None:
    names = ("out.blend", "out.json", "out.png")
    options = zip(("--output", "--report", "--image"), names, strict=True)
    done = run("segment", models / "torus.obj", *(word for pair in options for word in pair))
    assert done.returncode == 0, done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(names)


def test_failure_and_wrong_usage_have_statuses_of_their_own(run: Run, tmp_path: Path) -> None:
    missing = run("segment", "missing.obj", "--output", "out.blend")
    assert missing.returncode == 1
    assert "curvature: missing.obj: there is no such file" in missing.stderr.splitlines()
    assert run("segment", "missing.obj", "--panel-size", "wide").returncode == 2
    assert list(tmp_path.iterdir()) == []
