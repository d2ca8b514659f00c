# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The HTML report is one page that says what the document says, and needs nothing else."""

from __future__ import annotations

import re
from base64 import b64decode
from html.parser import HTMLParser
from typing import Any

import pytest
from architectural_curvature.addon.geometry.analysis import analyze
from architectural_curvature.addon.geometry.creases import DEFAULT_CREASE_ANGLE
from architectural_curvature.addon.geometry.criterion import (
    Criterion,
    panel_criterion,
    radius_criterion,
    raw_criterion,
)
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.segmentation import segment
from architectural_curvature.addon.geometry.settings import AnalysisSettings
from architectural_curvature.addon.geometry.tolerance import Tolerance
from architectural_curvature.addon.report.document import build_document
from architectural_curvature.addon.report.html import Picture, html_text
from architectural_curvature.addon.report.measures import measure_object
from solids import capped_cylinder


@pytest.fixture(scope="module")
def document() -> dict[str, Any]:
    """The report of a drum of radius 1: two flat caps, one single-curved wall."""
    analysis = analyze(
        mesh_from_polygons(*capped_cylinder(1.0, 2.0, 32, 8)),
        AnalysisSettings(DEFAULT_CREASE_ANGLE),
    )
    segmentation = segment(analysis.surface, analysis.curvature, Tolerance(0.5, 0.005))
    block = {"name": "Drum <1>", "source": "drum.obj", **measure_object(analysis, segmentation)}
    return build_document("1.2.3", "4.5.0", {"panel_size": 0.5, "deviation": None}, [block])


class _Balance(HTMLParser):
    """Counts elements that are opened and not closed again."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: object) -> None:
        del attrs
        if tag not in {"meta", "img", "rect", "line"}:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        if tag not in {"rect", "line"}:
            assert self.open.pop() == tag


def test_elements_are_closed_in_order(document: dict[str, Any]) -> None:
    parser = _Balance()
    parser.feed(html_text(document))
    assert parser.open == []


def test_nothing_is_fetched_from_elsewhere(document: dict[str, Any]) -> None:
    page = html_text(document, [Picture("Front", b"png")])
    assert not re.search(r"https?:|@import|<link|<script|url\(", page)
    assert re.findall(r"src='([^:]*):", page) == ["data"]


def test_pictures_are_inside_with_their_captions(document: dict[str, Any]) -> None:
    page = html_text(document, [Picture("From above", b"\x89PNG data")])
    (encoded,) = re.findall(r"data:image/png;base64,([^']*)'", page)
    assert b64decode(encoded) == b"\x89PNG data"
    assert "<figcaption>From above</figcaption>" in page


def test_names_are_escaped(document: dict[str, Any]) -> None:
    page = html_text(document)
    assert "Drum &lt;1&gt;" in page
    assert "Drum <1>" not in page


def test_the_class_table_says_what_the_document_says(document: dict[str, Any]) -> None:
    page = html_text(document)
    for key, name in (("flat", "Flat"), ("single_curved", "Single-Curved")):
        share = document["objects"][0]["classes"][key]["share"]
        assert re.search(rf"{name}</td>.*?<td>{100 * share:.1f} %</td>", page)


def test_colors_of_the_user_are_used(document: dict[str, Any]) -> None:
    assert "background:#123456" in html_text(document, colors={"flat": "#123456"})


def test_settings_that_differ_are_told(document: dict[str, Any]) -> None:
    assert "<td>Deviation</td><td>differs between the objects</td>" in html_text(document)


def _limits_said(criterion: Criterion) -> str:
    analysis = analyze(
        mesh_from_polygons(*capped_cylinder(1.0, 2.0, 32, 8)),
        AnalysisSettings(DEFAULT_CREASE_ANGLE),
    )
    segmentation = segment(analysis.surface, analysis.curvature, criterion)
    block = {"name": "Drum", "source": "", **measure_object(analysis, segmentation)}
    block["criterion_preset"], block["criterion_source"] = "Glass <8>", "By a maker"
    page = html_text(build_document("1.2.3", "4.5.0", {"criterion": criterion.kind.name}, [block]))
    assert "Preset Glass &lt;8&gt;: By a maker." in page
    assert f"<td>Criterion</td><td>{criterion.kind.value}</td>" in page
    return page


def test_every_criterion_is_said_in_words() -> None:
    # 0.5² / (8 · 0.005) = 6.25 m.
    page = _limits_said(panel_criterion(Tolerance(0.5, 0.005)))
    assert "straight above a radius of 6.25 m" in page
    assert "within 5 mm of a cylinder over a 0.5 m panel" in page
    assert "a radius of at least 3 m" in _limits_said(radius_criterion(3.0, 0.5))
    page = _limits_said(raw_criterion(0.01, 0.2, 0.5))
    assert "|K| of at most 0.01 1/m²" in page
    assert "|H| of at most 0.2 1/m" in page


def test_the_criterion_before_is_told(document: dict[str, Any]) -> None:
    block = {
        **document["objects"][0],
        "comparison": {"flat": {"before": 1.0, "after": 2.0}},
        "previous_criterion": "straight: radius of at least 3 m",
    }
    page = html_text({**document, "objects": [block]})
    assert "Criterion before: straight: radius of at least 3 m" in page


def test_histograms_hold_all_area(document: dict[str, Any]) -> None:
    block = document["objects"][0]
    for histogram in block["histograms"].values():
        assert sum(histogram["areas"]) == pytest.approx(block["area"])
        assert len(histogram["edges"]) == len(histogram["areas"]) + 1
    caps = block["histograms"]["larger"]["areas"][0]
    assert caps == pytest.approx(block["classes"]["flat"]["area"])
