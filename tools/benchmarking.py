# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Starting the benchmarks, which are a package of their own: tools/benchmark."""

from __future__ import annotations

import subprocess

from . import environments
from .places import ROOT
from .processes import python_environment


def run(what: str, *, quick: bool, held_out: bool, largest: int) -> int:
    """Run `python -m tools.benchmark` with the peers it compares with at hand.

    Parameters
    ----------
    what : str
        "accuracy" or "speed".
    quick : bool
        Small meshes only.
    held_out : bool
        Other surfaces.
    largest : int
        Number of vertices beyond which meshes are skipped; 0 for none.
    """
    arguments = [what, "--largest", str(largest)]
    arguments += ["--quick"] * quick + ["--held-out"] * held_out
    python = environments.ensure("benchmark")
    return subprocess.run(
        [python, "-m", "tools.benchmark", *arguments],
        cwd=ROOT,
        env=python_environment(),
        check=False,
    ).returncode
