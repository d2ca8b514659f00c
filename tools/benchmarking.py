# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Starting the benchmarks, which are a package of their own: tools/benchmark."""

from __future__ import annotations

import subprocess
from collections.abc import Sequence

from . import environments
from .errors import DevError
from .places import ROOT
from .processes import python_environment


def run(arguments: Sequence[str]) -> int:
    """Run `python -m tools.benchmark` with numpy, scipy and libigl at hand.

    Raises
    ------
    DevError
        If there is no such package.
    """
    if not (ROOT / "tools" / "benchmark").is_dir():
        raise DevError("there is no benchmark yet: the folder tools/benchmark is missing")
    python = environments.ensure("geometry")
    return subprocess.run(
        [python, "-m", "tools.benchmark", *arguments],
        cwd=ROOT,
        env=python_environment(),
        check=False,
    ).returncode
