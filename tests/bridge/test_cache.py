# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is kept in memory saves time and changes no number."""

from __future__ import annotations

from pathlib import Path

import bpy
import numpy as np
import pytest
from architectural_curvature.addon.bridge import cache, subject
from architectural_curvature.addon.geometry.analysis import Analysis, analyze
from models import STRICT, add_surface, barrel, dome, own_attributes, saddle, stored


@pytest.fixture(autouse=True)
def analyses(monkeypatch: pytest.MonkeyPatch) -> list[Analysis]:
    """The analyses that were computed, not taken from the cache."""
    computed: list[Analysis] = []

    def counted(*arguments: object) -> Analysis:
        computed.append(analyze(*arguments))
        return computed[-1]

    cache.clear()
    monkeypatch.setattr(subject, "analyze", counted)
    return computed


def _stored(name: str) -> dict[str, np.ndarray]:
    obj = bpy.data.objects[name]
    return {attribute: stored(obj, attribute) for attribute in own_attributes(obj)}


def test_same_model_is_measured_once(analyses: list[Analysis]) -> None:
    add_surface(dome)
    bpy.ops.curvature.analyze()
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.segment(panel_size=0.5)
    bpy.ops.curvature.show(quantity="K1")
    assert len(analyses) == 1


def test_results_are_the_same_with_a_cold_and_a_warm_cache(analyses: list[Analysis]) -> None:
    add_surface(saddle)
    bpy.ops.curvature.segment(**STRICT)
    cold = _stored("Roof")
    bpy.ops.curvature.clear()
    bpy.ops.curvature.segment(**STRICT)
    assert len(analyses) == 1
    warm = _stored("Roof")
    assert cold.keys() == warm.keys()
    for name, values in cold.items():
        assert np.array_equal(values, warm[name]), name


def test_loading_a_file_lets_go_of_the_file_before(
    tmp_path: Path, analyses: list[Analysis]
) -> None:
    add_surface(dome)
    bpy.ops.curvature.analyze()
    file = str(tmp_path / "dome.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.open_mainfile(filepath=file)
    bpy.data.objects["Roof"].select_set(True)
    bpy.ops.curvature.analyze()
    assert len(analyses) == 2


def test_other_settings_are_another_analysis(analyses: list[Analysis]) -> None:
    add_surface(barrel)
    bpy.ops.curvature.analyze(crease_angle=0.5)
    bpy.ops.curvature.analyze(crease_angle=0.6)
    bpy.ops.curvature.analyze(crease_angle=0.5)
    assert len(analyses) == 2


def test_oldest_analysis_goes_first(
    monkeypatch: pytest.MonkeyPatch, analyses: list[Analysis]
) -> None:
    # Room for two models of 16 x 16 quads.
    monkeypatch.setattr(cache, "_MOST_CORNERS", 2 * 256 * 4)
    for height, name in ((dome, "A"), (barrel, "B"), (saddle, "C")):
        bpy.ops.object.select_all(action="DESELECT")
        add_surface(height, name)
        bpy.context.scene.curvature.quantity = "NONE"
        bpy.ops.curvature.segment(**STRICT)
    kept = [id(analysis) for analysis in cache._kept.values()]
    assert kept == [id(analysis) for analysis in analyses[1:]]
