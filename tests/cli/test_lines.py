# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The subcommand `lines` writes the same lines to every format."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import fromstring

import bpy
import numpy as np
import pytest
from models import add_surface, barrel

SMALL = ("--image-size", "320x200")


@pytest.fixture
def vault(save: Callable[[str], Path]) -> Path:
    """A file with a barrel vault 2 m wide and long, which stands 10 m to the right."""
    add_surface(barrel, "Vault").location = (10.0, 0.0, 0.0)
    return save("vault.blend")


def _dxf(path: Path) -> list[tuple[str, bool, np.ndarray]]:
    """Return layer, closedness and points of every polyline."""
    rows = path.read_bytes().decode("ascii").split("\r\n")[:-1]
    tags = [(int(code), value) for code, value in zip(rows[::2], rows[1::2], strict=True)]
    assert tags[0] == (0, "SECTION")
    assert tags[-1] == (0, "EOF")
    starts = [n for n, tag in enumerate(tags) if tag[0] == 0]
    entities = [
        (tags[a][1], dict(tags[a + 1 : b]))
        for a, b in zip(starts, [*starts[1:], None], strict=True)
    ]
    found: list[tuple[str, bool, list]] = []
    for kind, values in entities:
        if kind == "POLYLINE":
            assert int(values[70]) & 8
            found.append((values[8], bool(int(values[70]) & 1), []))
        elif kind == "VERTEX":
            found[-1][2].append([float(values[code]) for code in (10, 20, 30)])
    return [(layer, closed, np.array(points)) for layer, closed, points in found]


def _obj(path: Path) -> list[np.ndarray]:
    rows = [row.split() for row in path.read_text(encoding="ascii").splitlines()]
    points = np.array([[float(x) for x in row[1:]] for row in rows if row[0] == "v"])
    return [points[np.array(row[1:], dtype=int) - 1] for row in rows if row[0] == "l"]


def _svg(path: Path) -> list[np.ndarray]:
    root = fromstring(path.read_text(encoding="utf-8"))
    left, top, width, height = (float(x) for x in root.attrib["viewBox"].split())
    assert root.attrib["width"] == f"{1000.0 * width:.6g}mm"
    found = []
    for element in root.iter("{http://www.w3.org/2000/svg}path"):
        numbers = re.findall(r"-?[\d.]+", element.attrib["d"])
        points = np.array(numbers, dtype=float).reshape(-1, 2)
        assert (points >= (left, top)).all()
        assert (points <= (left + width, top + height)).all()
        found.append(points * (1.0, -1.0))
    return found


def test_every_format_has_the_lines_of_the_report(
    command: Callable[..., Any], vault: Path, tmp_path: Path
) -> None:
    reports = []
    for ending in ("blend", "dxf", "svg", "obj"):
        out = tmp_path / f"out.{ending}"
        ended = command("lines", vault, "--spacing", 0.25, "--output", out, "--json")
        assert ended.status == 0, ended.err
        reports.append(ended.report["objects"][0]["curvature_lines"])
    assert all(each == reports[0] for each in reports)
    counts = [reports[0][f"family_{n}"]["count"] for n in (1, 2)]
    assert min(counts) >= 6
    dxf, obj, svg = (
        _dxf(tmp_path / "out.dxf"),
        _obj(tmp_path / "out.obj"),
        _svg(tmp_path / "out.svg"),
    )
    assert [sum(each[0] == f"LINES_{n}" for each in dxf) for n in (1, 2)] == counts
    assert len(obj) == len(svg) == sum(counts)
    for (_, _, one), two, plan in zip(dxf, obj, svg, strict=True):
        np.testing.assert_allclose(one, two, atol=1e-6)
        np.testing.assert_allclose(one[:, :2], plan, atol=1e-4)
        assert 9.0 - 1e-5 <= one[:, 0].min() <= one[:, 0].max() <= 11.0 + 1e-5
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "out.blend"))
    assert [len(bpy.data.objects[f"Vault Lines {n}"].data.splines) for n in (1, 2)] == counts
    # Family 2 of a vault, along k2 = 0, are its rulings.
    rulings = [points for layer, _, points in dxf if layer == "LINES_2"]
    assert max(np.ptp(points[:, 0]) for points in rulings) < 0.02


def test_result_line_report_and_picture(
    command: Callable[..., Any], vault: Path, tmp_path: Path
) -> None:
    image, report = tmp_path / "a.png", tmp_path / "a.json"
    ended = command(
        "lines", vault, "--families", "second", "--image", image, "--report", report, *SMALL
    )
    assert ended.status == 0, ended.err
    assert re.fullmatch(
        r"vault\.blend: Vault: \d+ lines of family 2, [\d.]+ m; 0 umbilics\n", ended.out
    )
    block = json.loads(report.read_text(encoding="utf-8"))["objects"][0]
    assert "family_1" not in block["curvature_lines"]
    assert block["umbilics"] == []
    assert image.stat().st_size > 1000


def test_csv_and_html_have_the_lines(
    command: Callable[..., Any], vault: Path, tmp_path: Path
) -> None:
    assert command("lines", vault, "--report", tmp_path / "a.csv").status == 0
    text = (tmp_path / "a.csv").read_text(encoding="utf-8-sig")
    assert "curvature_lines,family_1,count," in text
    assert command("lines", vault, "--report", tmp_path / "a.html").status == 0
    assert "Curvature lines" in (tmp_path / "a.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "arguments",
    [
        ("--output", "out.stl"),
        ("--spacing", "0"),
        ("--spacing", "-1"),
        ("--families", "third"),
        ("--panel-size", "1"),
    ],
)
def test_wrong_usage(arguments: tuple[str, str], command: Callable[..., Any], vault: Path) -> None:
    ended = command("lines", vault, *arguments)
    assert ended.status == 2
    assert ended.err.count("\n") == 1


def test_existing_drawing_is_not_replaced(
    command: Callable[..., Any], vault: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out.dxf"
    out.write_bytes(b"precious")
    assert command("lines", vault, "--output", out).status == 1
    assert out.read_bytes() == b"precious"
    assert command("lines", vault, "--output", out, "--overwrite").status == 0
    assert len(_dxf(out)) > 4


def test_too_fine_a_spacing_fails_in_one_line(command: Callable[..., Any], vault: Path) -> None:
    ended = command("lines", vault, "--spacing", "1e-6", "--quiet")
    assert ended.status == 1
    assert "too fine" in ended.err
    assert ended.err.count("\n") == 1


def test_asymptotic_lines_and_fits(command: Callable[..., Any], vault: Path) -> None:
    ended = command("lines", vault, "--spacing", "0.3", "--fit", "0.001", "--json")
    assert ended.report["objects"][0]["curvature_lines"]["deviation"] < 0.01
    ended = command("lines", vault, "--asymptotic", "--json")
    assert ended.status == 0, ended.err
    assert "asymptotic_lines" in ended.report["objects"][0]
