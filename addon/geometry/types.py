# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Names for the kinds of arrays that the geometry package passes around."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
"""Real numbers of any shape; the docstring of the user states it."""

Colors = NDArray[np.float32]
"""Rows of red, green, blue and alpha as Blender stores them."""

Indices = NDArray[np.int64]
"""Whole numbers that point into another array."""

Complexes = NDArray[np.complex128]
"""Complex numbers of any shape."""

Flags = NDArray[np.bool_]
"""One truth value per item."""

AnyArray = NDArray[Any]
"""An array whose type is not of interest."""

Coordinates = tuple[Floats, Floats, Floats]
"""x, y and z of positions, each contiguous, which is faster to compute on."""

Graph = Any
"""A scipy.sparse.csr_matrix; not named, because loading scipy must wait until it is needed."""

Progress = Callable[[float], None]
"""Called with the share of the work that is done, 0 to 1; may raise to stop the work."""
