# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Independent parts of a computation on several threads.

numpy and scipy let go of the interpreter while they work: two or more processors share the parts.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import fields
from typing import Any, TypeVar

import numpy as np

_Part = TypeVar("_Part")
_Result = TypeVar("_Result")

#: Threads: more gain little, as memory is what they wait for.
WORKERS = min(4, os.cpu_count() or 1)


def in_parallel(work: Callable[[_Part], _Result], parts: Sequence[_Part]) -> list[_Result]:
    """Return what the work makes of every part, in their order.

    Parameters
    ----------
    work : callable
        Receives a part; what it raises ends all.
    parts : sequence
    """
    if len(parts) < 2 or WORKERS < 2:
        return [work(part) for part in parts]
    with ThreadPoolExecutor(WORKERS) as workers:
        return list(workers.map(work, parts))


def joined(parts: Sequence[_Part]) -> _Part:
    """Return a dataclass of arrays from those of all parts, joined along the last axis."""
    first: Any = parts[0]
    names = [each.name for each in fields(first)]
    return type(first)(
        *(np.concatenate([getattr(part, name) for part in parts], axis=-1) for name in names)
    )
