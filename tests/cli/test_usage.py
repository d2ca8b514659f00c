# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong usage ends with status 2, one line, and before any work."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

WRONG = {
    "nothing": ([], "COMMAND"),
    "unknown command": (["fly"], "invalid choice: 'fly'"),
    "no model": (["segment"], "MODEL"),
    "unknown option": (["segment", "a.obj", "--fast"], "--fast"),
    "zero size": (["segment", "a.obj", "--panel-size", "0"], "must be greater than zero"),
    "negative size": (["segment", "a.obj", "--panel-size=-1"], "must be greater than zero"),
    "size in words": (["segment", "a.obj", "--panel-size", "big"], "'big' is not a number"),
    "no number": (["segment", "a.obj", "--deviation", "nan"], "'nan' is not a number"),
    "infinite": (["segment", "a.obj", "--deviation", "inf"], "'inf' is not a number"),
    "negative area": (["segment", "a.obj", "--min-area=-1"], "must not be negative"),
    "zero radius": (["segment", "a.obj", "--smallest-radius", "0"], "must be greater than zero"),
    "radius and deviation": (
        ["segment", "a.obj", "--smallest-radius", "3", "--deviation", "0.01"],
        "--deviation and --smallest-radius are limits of different kinds",
    ),
    "radius and curvature": (
        ["segment", "a.obj", "--smallest-radius", "3", "--mean-limit", "0.01"],
        "--smallest-radius and --mean-limit are limits of different kinds",
    ),
    "half of the raw limits": (
        ["segment", "a.obj", "--gaussian-limit", "0.1"],
        "--gaussian-limit and --mean-limit need each other",
    ),
    "angle of zero": (["segment", "a.obj", "--crease-angle", "0"], "above 0 and at most 180"),
    "angle too large": (["segment", "a.obj", "--crease-angle", "181"], "at most 180 degrees"),
    "picture size": (["segment", "a.obj", "--image-size", "10"], "must be like 1600x1000"),
    "tiny picture": (["segment", "a.obj", "--image-size", "8x8"], "must be like 1600x1000"),
    "quantity": (["segment", "a.obj", "--quantity", "BEAUTY"], "invalid choice: 'BEAUTY'"),
    "color map": (["segment", "a.obj", "--color-map", "JET"], "invalid choice: 'JET'"),
    "range": (["segment", "a.obj", "--range", "0"], "must be greater than zero"),
    "axis": (["segment", "a.obj", "--up", "X"], "invalid choice: 'X'"),
    "report ending": (
        ["segment", "a.obj", "--report", "a.txt"],
        "must end in .json or .csv or .html",
    ),
    "image ending": (["segment", "a.obj", "--image", "a.jpg"], "must end in .png"),
    "output ending": (["segment", "a.obj", "--output", "a.obj"], "must end in .blend"),
}


@pytest.mark.parametrize("kind", WRONG)
def test_wrong_usage_ends_in_one_line(kind: str, command: Callable[..., Any]) -> None:
    arguments, words = WRONG[kind]
    ended = command(*arguments)
    assert ended.status == 2
    assert ended.out == ""
    assert len(ended.err.splitlines()) == 1, ended.err
    assert words in ended.err
    assert "see --help" in ended.err


def test_wrong_usage_writes_nothing(
    command: Callable[..., Any], roof: Path, tmp_path: Path
) -> None:
    ended = command("segment", roof, "--report", tmp_path / "a.json", "--min-area", "much")
    assert ended.status == 2
    assert not (tmp_path / "a.json").exists()


@pytest.mark.parametrize("arguments", [["--help"], ["segment", "--help"]])
def test_help_is_given_on_request(arguments: list[str], command: Callable[..., Any]) -> None:
    ended = command(*arguments)
    assert ended.status == 0
    assert "usage: blender --command curvature" in ended.out
    assert not ended.err


def test_help_explains_every_documented_option(command: Callable[..., Any]) -> None:
    text = command("segment", "--help").out
    for option in (
        "--output",
        "--report",
        "--image",
        "--panel-size",
        "--deviation",
        "--smallest-radius",
        "--gaussian-limit",
        "--mean-limit",
        "--crease-angle",
        "--min-area",
        "--overwrite",
        "--quiet",
        "--json",
    ):
        assert option in text
