# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever quantity is chosen, its colors are on every analyzed model and made active."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import bpy
import numpy as np
import pytest
from bpy.types import Object
from models import STRICT, add_surface, barrel, dome, inner_vertices, plate, saddle, stored

NAMES = {
    "GAUSSIAN": "Gaussian Curvature",
    "MEAN": "Mean Curvature",
    "K1": "Principal Curvature 1",
    "K2": "Principal Curvature 2",
    "CLASS": "Curvature Class",
    "REGION": "Curvature Region",
}
CURVATURES = ("GAUSSIAN", "MEAN", "K1", "K2")


def _segmented(*heights: object) -> list:
    objects = [add_surface(height, f"Roof {n}") for n, height in enumerate(heights)]
    bpy.ops.curvature.segment(**STRICT)
    return objects


@pytest.mark.parametrize("quantity", NAMES)
def test_color_attribute_is_written_and_made_active(quantity: str) -> None:
    objects = _segmented(dome, saddle)
    assert bpy.ops.curvature.show(quantity=quantity) == {"FINISHED"}
    assert bpy.context.scene.curvature.quantity == quantity
    for obj in objects:
        assert obj.data.color_attributes.active_color.name == NAMES[quantity]
        colors = stored(obj, NAMES[quantity])
        assert np.isfinite(colors).all()
        assert (colors >= 0.0).all()
        assert (colors <= 1.0).all()
        assert (colors[:, 3] == 1.0).all()


def test_positive_and_negative_curvature_have_the_two_ends_of_the_map() -> None:
    """Cool to Warm: a dome is red, a saddle blue, a plate neither."""
    domed, saddled, flat = _segmented(dome, saddle, plate)
    bpy.ops.curvature.show(quantity="GAUSSIAN")
    red_minus_blue = [
        np.median(stored(obj, "Gaussian Curvature")[:, 0] - stored(obj, "Gaussian Curvature")[:, 2])
        for obj in (domed, saddled, flat)
    ]
    assert red_minus_blue[0] > 0.2
    assert red_minus_blue[1] < -0.1
    assert red_minus_blue[2] == pytest.approx(0.0, abs=0.05)


@pytest.mark.parametrize("quantity", CURVATURES)
def test_range_is_symmetric_and_holds_the_asked_share(quantity: str) -> None:
    (obj,) = _segmented(saddle)
    settings = bpy.context.scene.curvature
    settings.range_percentile = 90.0
    bpy.ops.curvature.show(quantity=quantity)
    name = {"GAUSSIAN": "gaussian", "MEAN": "mean"}.get(quantity, quantity.lower())
    sizes = np.abs(stored(obj, f"curvature_{name}"))
    # By vertex instead of by area: the shares differ by the smaller cells of the rim.
    assert (sizes > settings.shown_limit).mean() == pytest.approx(0.1, abs=0.05)
    assert settings.shown_clipped == pytest.approx(0.1, abs=0.05)


def test_fixed_range_is_the_one_shown() -> None:
    _segmented(dome)
    settings = bpy.context.scene.curvature
    settings.range_mode, settings.range_limit = "FIXED", 0.75
    bpy.ops.curvature.show(quantity="MEAN")
    assert settings.shown_limit == pytest.approx(0.75)


def test_all_models_of_the_scene_share_one_range() -> None:
    """A gentle roof is vivid on its own and pale beside a dome."""

    def saturation(obj: Object) -> float:
        colors = stored(obj, "Mean Curvature")[inner_vertices(obj), :3]
        return float(np.ptp(colors, axis=1).mean())

    gentle = add_surface(lambda x, y: 0.1 * dome(x, y), "Gentle")
    bpy.ops.curvature.analyze()
    bpy.ops.curvature.show(quantity="MEAN")
    alone = saturation(gentle)
    add_surface(dome, "Dome")
    bpy.ops.curvature.analyze()
    assert saturation(gentle) < 0.6 * alone


def test_color_map_and_class_colors_follow_at_once() -> None:
    (obj,) = _segmented(dome)
    settings = bpy.context.scene.curvature
    settings.color_elliptic = (0.125, 0.25, 0.5)
    assert stored(obj, "Curvature Class")[0, :3] == pytest.approx([0.125, 0.25, 0.5])
    bpy.ops.curvature.show(quantity="MEAN")
    before = stored(obj, "Mean Curvature").copy()
    settings.color_map = "SPECTRUM"
    assert (stored(obj, "Mean Curvature") != before).any()


def test_regions_have_colors_of_their_own() -> None:
    (obj,) = _segmented(lambda x, _y: -np.abs(x))
    bpy.ops.curvature.show(quantity="REGION")
    colors = stored(obj, "Curvature Region").reshape(-1, 4, 4)[:, 0]
    regions = stored(obj, "curvature_region")
    assert len(np.unique(colors[regions == 0], axis=0)) == 1
    assert len(np.unique(colors[regions == 1], axis=0)) == 1
    assert (colors[regions == 0][0] != colors[regions == 1][0]).any()


def test_classes_that_do_not_exist_are_refused_in_words(run: Callable[..., Any]) -> None:
    add_surface(dome)
    bpy.ops.curvature.analyze()
    assert run("show", quantity="CLASS") == (
        {"CANCELLED"},
        "Error: There are no classes yet: press Segment first",
    )
    assert bpy.context.scene.curvature.quantity == "GAUSSIAN"


@pytest.mark.parametrize("quantity", ["MEAN", "K2"])
def test_analysis_keeps_the_curvature_that_is_shown(quantity: str) -> None:
    _segmented(barrel)
    bpy.ops.curvature.show(quantity=quantity)
    bpy.ops.curvature.analyze()
    assert bpy.context.scene.curvature.quantity == quantity


def test_flat_model_shows_no_invented_colors() -> None:
    (obj,) = _segmented(plate)
    bpy.ops.curvature.show(quantity="GAUSSIAN")
    assert np.ptp(stored(obj, "Gaussian Curvature")[:, :3], axis=1) == pytest.approx(0.0, abs=0.05)
