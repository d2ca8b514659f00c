# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Colors say what a value is: its sign, its size, its class or region."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.classification import SurfaceClass
from architectural_curvature.addon.geometry.display.colormap import (
    ColorMap,
    linear_from_srgb,
    map_colors,
    srgb_from_linear,
    srgb_ramp,
)
from architectural_curvature.addon.geometry.display.palette import (
    CLASS_COLORS,
    CLASS_NAMES,
    class_color_table,
    default_class_colors,
    region_colors,
)

DIVERGING = [ColorMap.COOL_WARM, ColorMap.PURPLE_ORANGE]

#: Colors are stored in single precision; the matrix of sRGB has seven digits.
ROUNDING = 1e-5


def _luminance(srgb: np.ndarray) -> np.ndarray:
    return linear_from_srgb(srgb) @ [0.2126, 0.7152, 0.0722]


@pytest.mark.parametrize("color_map", ColorMap)
def test_values_beyond_the_limit_have_the_last_color(color_map: ColorMap) -> None:
    values = np.array([-1e9, -2.0, 2.0, 1e9])
    colors = map_colors(values, 2.0, color_map)
    assert np.array_equal(colors[0], colors[1])
    assert np.array_equal(colors[2], colors[3])
    ends = linear_from_srgb(srgb_ramp(color_map, 2))
    np.testing.assert_allclose(colors[[0, 3], :3], ends, atol=ROUNDING)


@pytest.mark.parametrize("color_map", ColorMap)
def test_zero_has_the_middle_color_whatever_the_limit(color_map: ColorMap) -> None:
    middle = linear_from_srgb(srgb_ramp(color_map, 3)[1])
    for limit in (1e-6, 1.0, 1e6):
        color = map_colors(np.zeros(1), limit, color_map)[0]
        np.testing.assert_allclose(color[:3], middle, atol=ROUNDING)


@pytest.mark.parametrize("color_map", ColorMap)
def test_colors_are_opaque_and_in_gamut(color_map: ColorMap) -> None:
    colors = map_colors(np.linspace(-3.0, 3.0, 301), 2.0, color_map)
    assert colors.dtype == np.float32
    assert (colors[:, 3] == 1.0).all()
    assert ((colors >= 0.0) & (colors <= 1.0)).all()


@pytest.mark.parametrize("color_map", ColorMap)
def test_units_do_not_change_colors(color_map: ColorMap) -> None:
    values = np.linspace(-1.0, 1.0, 33)
    assert np.array_equal(
        map_colors(values, 1.0, color_map), map_colors(values * 1024.0, 1024.0, color_map)
    )


@pytest.mark.parametrize("color_map", DIVERGING)
def test_the_middle_is_the_lightest_and_darkens_evenly_to_both_ends(color_map: ColorMap) -> None:
    ramp = srgb_ramp(color_map, 65)
    light = _luminance(ramp)
    assert light.argmax() == 32
    assert (np.diff(light[:33]) > 0.0).all()
    assert (np.diff(light[32:]) < 0.0).all()
    # Near-white: red, green and blue nearly agree.
    assert np.ptp(ramp[32]) < 0.02


def test_cool_is_blue_and_warm_is_red_with_the_ends_that_moreland_gives() -> None:
    ends = srgb_ramp(ColorMap.COOL_WARM, 2) * 255.0
    np.testing.assert_allclose(ends, [[59, 76, 192], [180, 4, 38]], atol=0.05)


def test_the_spectrum_runs_from_blue_over_green_to_red() -> None:
    low, middle, high = srgb_ramp(ColorMap.SPECTRUM, 3)
    assert (low.argmax(), middle.argmax(), high.argmax()) == (2, 1, 0)


def test_the_transfer_curve_of_srgb_and_its_inverse() -> None:
    srgb = np.linspace(0.0, 1.0, 1001)
    # Both branches of the standard meet at 0.04045 up to 3e-8 in linear, 1e-7 in sRGB.
    np.testing.assert_allclose(srgb_from_linear(linear_from_srgb(srgb)), srgb, atol=1e-6)
    assert linear_from_srgb(np.array([0.0, 1.0])).tolist() == [0.0, 1.0]
    # A middle gray of 50 % reflects 21.4 %.
    assert linear_from_srgb(np.array(0.5)) == pytest.approx(0.2140, abs=1e-4)


def test_every_class_has_a_name_and_a_color_of_its_own() -> None:
    assert set(CLASS_NAMES) == set(CLASS_COLORS) == set(SurfaceClass)
    assert len(set(CLASS_NAMES.values())) == len(SurfaceClass)
    colors = np.array(list(CLASS_COLORS.values()))
    gaps = np.linalg.norm(colors[:, None] - colors[None], axis=2) + 9.0 * np.eye(len(colors))
    assert gaps.min() > 0.25


def test_the_color_table_is_found_by_class_number() -> None:
    table = class_color_table(default_class_colors())
    assert table.shape == (5, 4)
    for surface_class, color in CLASS_COLORS.items():
        found = table[int(surface_class) + 1]
        np.testing.assert_allclose(srgb_from_linear(found[:3]), color, atol=1e-6)
        assert found[3] == 1.0


def test_a_region_keeps_its_color_whatever_other_regions_there_are() -> None:
    few = region_colors(np.array([0, 1, 2]))
    many = region_colors(np.array([7, 2, 1, 0, -1, 30]))
    assert np.array_equal(few, many[[3, 2, 1]])


def test_neighboring_numbers_have_colors_that_differ() -> None:
    colors = region_colors(np.arange(40))[:, :3]
    gaps = np.linalg.norm(srgb_from_linear(colors[1:]) - srgb_from_linear(colors[:-1]), axis=1)
    assert gaps.min() > 0.25


def test_faces_without_region_have_the_color_of_the_undefined() -> None:
    colors = region_colors(np.array([-1, -1]))
    expected = linear_from_srgb(np.array(CLASS_COLORS[SurfaceClass.UNDEFINED]))
    np.testing.assert_allclose(colors[:, :3], [expected, expected], atol=ROUNDING)
    assert region_colors(np.empty(0, dtype=np.int64)).shape == (0, 4)
