# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings are read again by parsers of our own that know the formats, not the writers."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree.ElementTree import fromstring

import numpy as np
import pytest
from architectural_curvature.addon.export.drawing import Drawing, Layer, Polyline
from architectural_curvature.addon.export.formats import TEXTS, write_drawing
from architectural_curvature.addon.report.files import FileRefusedError

_SVG = "{http://www.w3.org/2000/svg}"
OPEN = np.array([[1000.125, -2.5, 0.0], [1001.5, 0.0, 0.75], [1003.0, 1.0, -1e-7]])
RING = np.array([[1000.0, 0.0, 3.0], [1001.0, 0.0, 3.0], [1001.0, 1.0, 3.0], [1000.0, 1.0, 3.0]])


@pytest.fixture
def drawing() -> Drawing:
    """Two families, one with an open and a closed line."""
    first = Layer("Lines 1", (0.7, 0.1, 0.1), 0.05, (Polyline(OPEN, False), Polyline(RING, True)))
    second = Layer("Lines 2", (0.1, 0.1, 0.7), 0.05, (Polyline(OPEN[::-1], False),))
    return Drawing("Dächer & <Hallen>", (first, second))


def _tags(text: str) -> list[tuple[int, str]]:
    rows = text.split("\r\n")
    assert rows.pop() == ""
    assert len(rows) % 2 == 0
    return [(int(code), value) for code, value in zip(rows[::2], rows[1::2], strict=True)]


def test_dxf_sections_and_tables_are_closed(drawing: Drawing) -> None:
    tags = _tags(TEXTS[".dxf"](drawing))
    words = [value for code, value in tags if code == 0]
    assert words.count("SECTION") == words.count("ENDSEC") == 3
    assert words.count("TABLE") == words.count("ENDTAB") == 2
    assert words.count("POLYLINE") == words.count("SEQEND") == 3
    assert words[-1] == "EOF"
    assert (1, "AC1009") in tags
    sections = [tags[n + 1][1] for n, tag in enumerate(tags) if tag == (0, "SECTION")]
    assert sections == ["HEADER", "TABLES", "ENTITIES"]


def test_dxf_lines_lie_on_layers_that_are_declared(drawing: Drawing) -> None:
    tags = _tags(TEXTS[".dxf"](drawing))
    declared = [tags[n + 1][1] for n, tag in enumerate(tags) if tag == (0, "LAYER")]
    assert declared == ["LINES_1", "LINES_2"]
    assert {value for code, value in tags if code == 8} == set(declared)
    colors = [int(value) for code, value in tags if code == 62]
    assert colors == [1, 5], "red and blue by their numbers in AutoCAD"


def test_dxf_has_the_points_in_space(drawing: Drawing) -> None:
    found: list[tuple[int, list[list[float]]]] = []
    kind = ""
    for code, value in _tags(TEXTS[".dxf"](drawing)):
        if code == 0:
            kind = value
            if kind == "POLYLINE":
                found.append((0, []))
            elif kind == "VERTEX":
                found[-1][1].append([])
        elif kind == "VERTEX" and code in {10, 20, 30}:
            found[-1][1][-1].append(float(value))
        elif kind == "POLYLINE" and code == 70:
            found[-1] = (int(value), found[-1][1])
    assert [flags for flags, _ in found] == [8, 9, 8]
    for (_, points), expected in zip(found, (OPEN, RING, OPEN[::-1]), strict=True):
        np.testing.assert_allclose(points, expected, atol=1e-5)


def test_obj_lines_point_at_their_vertices(drawing: Drawing) -> None:
    rows = [row.split() for row in TEXTS[".obj"](drawing).splitlines()]
    vertices = np.array([[float(x) for x in row[1:]] for row in rows if row[0] == "v"])
    lines = [vertices[np.array(row[1:], dtype=int) - 1] for row in rows if row[0] == "l"]
    np.testing.assert_allclose(lines[0], OPEN, atol=1e-5)
    np.testing.assert_allclose(lines[1], np.concatenate([RING, RING[:1]]), atol=1e-5)
    np.testing.assert_allclose(lines[2], OPEN[::-1], atol=1e-5)
    assert [row[1] for row in rows if row[0] == "o"] == ["Lines_1", "Lines_2"]


def test_svg_is_the_plan_at_true_size(drawing: Drawing) -> None:
    root = fromstring(TEXTS[".svg"](drawing))
    assert root.find(f"{_SVG}title").text == "Dächer & <Hallen>"
    left, top, width, height = (float(part) for part in root.attrib["viewBox"].split())
    assert float(root.attrib["width"].removesuffix("mm")) == pytest.approx(1000.0 * width, rel=1e-5)
    assert float(root.attrib["height"].removesuffix("mm")) == pytest.approx(
        1000.0 * height, rel=1e-5
    )
    groups = root.findall(f"{_SVG}g")
    assert [len(group) for group in groups] == [2, 1]
    assert [group.attrib["id"] for group in groups] == ["lines-1", "lines-2"]
    paths = [path.attrib["d"] for path in root.iter(f"{_SVG}path")]
    assert [path.endswith("Z") for path in paths] == [False, True, False]
    for path, expected in zip(paths, (OPEN, RING, OPEN[::-1]), strict=True):
        points = np.array(re.findall(r"-?[\d.]+", path), dtype=float).reshape(-1, 2)
        np.testing.assert_allclose(points * (1.0, -1.0), expected[:, :2], atol=1e-5)
        assert (points[:, 0] > left).all()
        assert (points[:, 0] < left + width).all()
        assert (points[:, 1] > top).all()
        assert (points[:, 1] < top + height).all()


@pytest.mark.parametrize("ending", TEXTS)
def test_no_lines_make_a_sound_file(ending: str, tmp_path: Path) -> None:
    path = tmp_path / f"empty{ending}"
    write_drawing(path, Drawing("", ()))
    text = path.read_bytes().decode()
    assert text
    if ending == ".svg":
        fromstring(text)


def test_other_endings_are_refused(drawing: Drawing, tmp_path: Path) -> None:
    with pytest.raises(FileRefusedError, match=r"drawings end in \.dxf, \.svg, \.obj, not in"):
        write_drawing(tmp_path / "lines.dwg", drawing)
    assert list(tmp_path.iterdir()) == []
