# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Second-order Taylor arithmetic in two variables: exact derivatives of any formula.

A surface is written once, as a formula in u and v; its derivatives follow by the rules of calculus.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Taylor:
    """A function of u and v with its derivatives f, f_u, f_v, f_uu, f_uv, f_vv, (6, n) float64."""

    # Without this numpy's scalars would take a Taylor on their right for an array.
    __array_ufunc__ = None

    def __init__(self, parts: Array) -> None:
        self.parts = parts

    def chained(self, value: Array, first: Array, second: Array) -> Taylor:
        """Return g(f), given g and its first and second derivative at f."""
        _, u, v, uu, uv, vv = self.parts
        return Taylor(
            np.stack(
                [
                    value,
                    first * u,
                    first * v,
                    second * u * u + first * uu,
                    second * u * v + first * uv,
                    second * v * v + first * vv,
                ]
            )
        )

    def __add__(self, other: Taylor | float) -> Taylor:
        return Taylor(self.parts + self._like(other).parts)

    __radd__ = __add__

    def __neg__(self) -> Taylor:
        return Taylor(-self.parts)

    def __sub__(self, other: Taylor | float) -> Taylor:
        return self + -self._like(other)

    def __rsub__(self, other: float) -> Taylor:
        return -self + other

    def __mul__(self, other: Taylor | float) -> Taylor:
        f, fu, fv, fuu, fuv, fvv = self.parts
        g, gu, gv, guu, guv, gvv = self._like(other).parts
        return Taylor(
            np.stack(
                [
                    f * g,
                    fu * g + f * gu,
                    fv * g + f * gv,
                    fuu * g + 2.0 * fu * gu + f * guu,
                    fuv * g + fu * gv + fv * gu + f * guv,
                    fvv * g + 2.0 * fv * gv + f * gvv,
                ]
            )
        )

    __rmul__ = __mul__

    def __truediv__(self, other: Taylor | float) -> Taylor:
        f = self._like(other).parts[0]
        return self * self._like(other).chained(1.0 / f, -1.0 / f**2, 2.0 / f**3)

    def _like(self, value: Taylor | float) -> Taylor:
        if isinstance(value, Taylor):
            return value
        parts = np.zeros_like(self.parts)
        parts[0] = value
        return Taylor(parts)


def variables(u: Array, v: Array) -> tuple[Taylor, Taylor]:
    """Return u and v themselves as functions of u and v."""
    zero, one = np.zeros_like(u), np.ones_like(u)
    return (
        Taylor(np.stack([u, one, zero, zero, zero, zero])),
        Taylor(np.stack([v, zero, one, zero, zero, zero])),
    )


def sin(f: Taylor) -> Taylor:
    """Return the sine."""
    value = np.sin(f.parts[0])
    return f.chained(value, np.cos(f.parts[0]), -value)


def cos(f: Taylor) -> Taylor:
    """Return the cosine."""
    value = np.cos(f.parts[0])
    return f.chained(value, -np.sin(f.parts[0]), -value)


def cosh(f: Taylor) -> Taylor:
    """Return the hyperbolic cosine."""
    value = np.cosh(f.parts[0])
    return f.chained(value, np.sinh(f.parts[0]), value)
