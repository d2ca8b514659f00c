# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Color maps for signed quantities: zero in the middle, colors that grow apart evenly."""

from __future__ import annotations

import colorsys
from enum import Enum
from functools import cache

import numpy as np

from ..types import Colors, Floats

_SAMPLES = 129

#: Reference white of sRGB (D65) and the matrix from linear sRGB to CIE XYZ, IEC 61966-2-1.
_WHITE = np.array([0.95047, 1.0, 1.08883])
_RGB_TO_XYZ = np.array(
    [
        [0.4124564, 0.3575761, 0.1804375],
        [0.2126729, 0.7151522, 0.0721750],
        [0.0193339, 0.1191920, 0.9503041],
    ]
)


class ColorMap(Enum):
    """Color maps to choose from; the value is the name that users read."""

    COOL_WARM = "Cool to Warm"
    PURPLE_ORANGE = "Purple to Orange"
    SPECTRUM = "Spectrum"


def map_colors(values: Floats, limit: float, color_map: ColorMap) -> Colors:
    """Return the colors of values, with zero in the middle of the map.

    Parameters
    ----------
    values : (n,) float64
    limit : float
        The value that gets the last color, and its negative the first; beyond them the color
        stays. Greater than zero.
    color_map : ColorMap

    Returns
    -------
    (n, 4) float32
        Scene-linear red, green, blue and an alpha of 1, as Blender stores colors.
    """
    place = np.clip(values / limit, -1.0, 1.0)
    index = np.rint((place + 1.0) * 0.5 * (_SAMPLES - 1)).astype(np.int64)
    return _linear_table(color_map)[index]


def srgb_ramp(color_map: ColorMap, count: int) -> Floats:
    """Return evenly spaced colors of a map from the lowest to the highest value.

    Returns
    -------
    (count, 3) float64
        sRGB, 0 to 1.
    """
    place = np.linspace(-1.0, 1.0, count)
    if color_map is ColorMap.SPECTRUM:
        # Red for the highest value, green for zero, blue for the lowest: hue 0 to 240 degrees.
        return np.array([colorsys.hsv_to_rgb((1.0 - p) / 3.0, 1.0, 0.95) for p in place])
    if color_map is ColorMap.PURPLE_ORANGE:
        return _diverging(np.array([0.436, 0.308, 0.631]), np.array([0.759, 0.334, 0.046]), place)
    return _diverging(np.array([59, 76, 192]) / 255.0, np.array([180, 4, 38]) / 255.0, place)


def linear_from_srgb(srgb: Floats) -> Floats:
    """Return scene-linear colors for sRGB ones of any shape, 0 to 1, IEC 61966-2-1."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def srgb_from_linear(linear: Floats) -> Floats:
    """Return sRGB colors for scene-linear ones of any shape, 0 to 1, IEC 61966-2-1."""
    linear = np.clip(linear, 0.0, 1.0)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055)


@cache
def _linear_table(color_map: ColorMap) -> Colors:
    linear = linear_from_srgb(srgb_ramp(color_map, _SAMPLES))
    return np.concatenate([linear, np.ones((_SAMPLES, 1))], axis=1).astype(np.float32)


def _diverging(low: Floats, high: Floats, place: Floats) -> Floats:
    """Interpolate from one hue over near-white to another, evenly to the eye.

    References
    ----------
    .. [1] K. Moreland (2009). Diverging color maps for scientific visualization, section 5.
    """
    ends = [_msh_from_srgb(low), _msh_from_srgb(high)]
    middle = max(ends[0][0], ends[1][0], 88.0)
    colors: list[Floats] = []
    for p in place:
        end = ends[0] if p < 0.0 else ends[1]
        share = abs(p)
        hue = _hue_near_white(end, middle)
        msh = np.array(
            [
                middle + share * (end[0] - middle),
                share * end[1],
                hue + share * (end[2] - hue),
            ]
        )
        colors.append(_srgb_from_msh(msh))
    return np.clip(np.array(colors), 0.0, 1.0)


def _hue_near_white(end: Floats, middle: float) -> float:
    """Return the hue that keeps the steps of a ramp to near-white even in lightness and color."""
    magnitude, saturation, hue = end
    if magnitude >= middle:
        return hue
    spin = saturation * np.sqrt(middle**2 - magnitude**2) / (magnitude * np.sin(saturation))
    return hue + spin if hue > -np.pi / 3.0 else hue - spin


def _msh_from_srgb(srgb: Floats) -> Floats:
    xyz = _RGB_TO_XYZ @ linear_from_srgb(srgb) / _WHITE
    f = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16.0 / 116.0)
    lab = np.array([116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])])
    magnitude = float(np.linalg.norm(lab))
    return np.array([magnitude, np.arccos(lab[0] / magnitude), np.arctan2(lab[2], lab[1])])


def _srgb_from_msh(msh: Floats) -> Floats:
    magnitude, saturation, hue = msh
    lab = magnitude * np.array(
        [np.cos(saturation), np.sin(saturation) * np.cos(hue), np.sin(saturation) * np.sin(hue)]
    )
    fy = (lab[0] + 16.0) / 116.0
    f = np.array([fy + lab[1] / 500.0, fy, fy - lab[2] / 200.0])
    xyz = np.where(f > 0.206893, f**3, (f - 16.0 / 116.0) / 7.787) * _WHITE
    return srgb_from_linear(np.linalg.solve(_RGB_TO_XYZ, xyz))
