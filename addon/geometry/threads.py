# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Independent parts of a computation on several threads.

numpy and scipy let go of the interpreter while they work: two or more processors share the parts.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

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
