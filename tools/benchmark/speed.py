# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Time and peak memory, each run in a process of its own.

Machines differ and are shared: what counts is the ratio to libigl's default in the same run.
"""

from __future__ import annotations

import json
import subprocess
import sys
import threading
import time
from pathlib import Path

from . import plots, report, segmenting, whole_operator
from .engine import ROOT
from .peers import DEFAULT, LIMIT, METHODS, OURS

_KINDS = ("irregular 4:1", "irregular 4:1, float32", "noise 1 %")
_SIZES = (20_000, 100_000, 1_000_000)
_QUICK = (20_000, 50_000)
_LARGEST_NOISY = 100_000
_SURFACE = "torus"


def run(*, quick: bool, largest: int) -> None:
    """Measure, print, and write docs/accuracy.md and its plot unless it is a partial run."""
    lines = [
        "| mesh | vertices | method | seconds | of igl's default | MB above the input |",
        "|---|---|---|---|---|---|",
    ]
    curves: dict[tuple[str, str], list[tuple[int, float]]] = {}
    for kind in _KINDS:
        for size in _QUICK if quick else _SIZES:
            if (largest and size > largest) or (size > _LARGEST_NOISY and "noise" in kind):
                continue
            base = 0.0
            # The default goes first: all others are compared with it.
            for method in sorted(METHODS, key=lambda name: name != DEFAULT):
                if size > LIMIT.get(method, size) or (quick and method not in {OURS, DEFAULT}):
                    continue
                seconds, memory = _measured(kind, size, method)
                base = base or seconds
                lines.append(
                    f"| {kind} | {size:,} | {method} | {seconds:.2f} | {seconds / base:.2f} "
                    f"| {memory:.0f} |"
                )
                print(lines[-1], flush=True)
                curves.setdefault((kind, method), []).append((size, seconds))
    segmentation = segmenting.measure(quick=quick, largest=largest)
    if not (quick or largest):
        report.write(
            {
                "speed": "\n".join(lines),
                "operator": whole_operator.measure(),
                "segmentation": segmentation,
            }
        )
        plots.times(curves)


def _measured(kind: str, size: int, method: str) -> tuple[float, float]:
    """Return seconds and megabytes of one method in a fresh process."""
    done = subprocess.run(
        [sys.executable, "-m", "tools.benchmark.speed", kind, str(size), method],
        capture_output=True,
        text=True,
        check=True,
        cwd=ROOT,
    )
    found = json.loads(done.stdout.splitlines()[-1])
    return found["seconds"], found["megabytes"]


def _resident() -> float:
    """Return the memory this process has in use, in megabytes; 0 where that cannot be read."""
    status = Path("/proc/self/statm")
    return int(status.read_text().split()[1]) * 4096 / 1e6 if status.exists() else 0.0


def _alone(kind: str, size: int, method: str) -> None:
    """Run one method and print its time and peak memory."""
    from .meshes import KINDS, make
    from .peers import ours

    small, case = make(_SURFACE, kind, 2_000), make(_SURFACE, kind, size)
    METHODS[method](small.positions, small.triangles)  # libraries load before the clock starts
    before = peak = _resident()
    is_done = threading.Event()

    def watch() -> None:
        nonlocal peak
        while not is_done.wait(0.02):
            peak = max(peak, _resident())

    watcher = threading.Thread(target=watch)
    watcher.start()
    start = time.perf_counter()
    if method == OURS and KINDS[kind][2]:
        ours(case.positions, case.triangles, float(2.0**-23 * abs(case.positions).max()))
    else:
        METHODS[method](case.positions, case.triangles)
    seconds = time.perf_counter() - start
    is_done.set()
    watcher.join()
    print(json.dumps({"seconds": seconds, "megabytes": max(peak, _resident()) - before}))


if __name__ == "__main__":
    _alone(sys.argv[1], int(sys.argv[2]), sys.argv[3])
