# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Running the tests: plain Python first, then each Blender with the built zip installed."""

from __future__ import annotations

import os
import subprocess
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree

from . import build, environments
from .blenders import SERIES, Blender
from .console import say, warn
from .places import ROOT
from .platforms import current_platform
from .processes import python_environment

_PLAIN_LEVELS = ("policy", "packaging", "geometry", "report")
# Every other folder of tests, but the one for windows, runs in Blender; these must not be missing.
_BLENDER_LEVELS = ("bridge", "operators", "extension")
_WINDOW_LEVEL = "window"
_PYTEST_NOTHING_SELECTED = 5


@dataclass
class Counts:
    """How many tests passed, failed and were skipped."""

    passed: int = 0
    failed: int = 0
    skipped: int = 0

    def add(self, other: Counts) -> None:
        """Add the counts of another stage."""
        self.passed += other.passed
        self.failed += other.failed
        self.skipped += other.skipped

    def __str__(self) -> str:
        return f"{self.passed} passed, {self.failed} failed, {self.skipped} skipped"


@dataclass
class Stage:
    """One pytest process: the folders it runs and where it runs them."""

    name: str
    environment: str
    folders: Sequence[str]
    variables: dict[str, str] = field(default_factory=dict)


def run(blenders: Sequence[Blender], only: Sequence[str] | None, options: Sequence[str]) -> int:
    """Run the tests and print the closing line.

    Parameters
    ----------
    blenders : sequence of Blender
        In which Blenders the levels that need one are run.
    only : sequence of str, optional
        The levels to run ("policy", "packaging", "geometry", "report", "blender"); all by default.
    options : sequence of str
        Passed on to every pytest.

    Returns
    -------
    int
        0 if something passed and nothing failed, else 1.
    """
    levels = only or [*_PLAIN_LEVELS, "blender"]
    total = Counts()
    lines = []
    for stage in _stages(blenders, levels):
        start = time.monotonic()
        counts = run_stage(stage, options)
        lines.append(f"{stage.name}: {counts}, {time.monotonic() - start:.1f} s")
        total.add(counts)
    for line in lines:
        say(line)
    print(total, flush=True)
    return 0 if total.passed and not total.failed else 1


def _stages(blenders: Sequence[Blender], levels: Sequence[str]) -> list[Stage]:
    stages = [Stage(level, "geometry", [level]) for level in _PLAIN_LEVELS if level in levels]
    environments.ensure_all(
        [
            *(["geometry"] if stages else []),
            *([blender.environment for blender in blenders] if "blender" in levels else []),
        ]
    )
    if "blender" in levels:
        stages += _blender_stages(blenders)
    return stages


def _blender_stages(blenders: Sequence[Blender]) -> list[Stage]:
    """Build both series: each Blender installs its own and is shown to refuse the other."""
    found = {path.parent.name for path in (ROOT / "tests").glob("*/test_*.py")}
    others = found - {*_PLAIN_LEVELS, *_BLENDER_LEVELS, _WINDOW_LEVEL}
    zips = {name: build.build(series, [current_platform()])[0] for name, series in SERIES.items()}
    stages = []
    for blender in blenders:
        other = next(name for name in SERIES if name != blender.series.name)
        stages.append(
            Stage(
                f"Blender {blender.version}",
                blender.environment,
                (*_BLENDER_LEVELS, *sorted(others)),
                {
                    "ARCHITECTURAL_CURVATURE_ZIP": os.fspath(zips[blender.series.name]),
                    "ARCHITECTURAL_CURVATURE_OTHER_ZIP": os.fspath(zips[other]),
                },
            )
        )
    return stages


def run_stage(stage: Stage, options: Sequence[str]) -> Counts:
    """Run one pytest process and return its counts; a process that dies counts as a failed test."""
    folders = [ROOT / "tests" / name for name in stage.folders]
    present = [folder for folder in folders if any(folder.rglob("test_*.py"))]
    for folder in folders:
        if folder not in present:
            warn(f"{folder.relative_to(ROOT)} has no tests: nothing was run for {stage.name}")
    named, options = _take_paths(options)
    chosen = present
    if named:
        chosen = [path for path in named if any(_is_in(path, folder) for folder in present)]
    if not chosen:
        return Counts()
    say(f"testing {stage.name}")
    python = environments.ensure(stage.environment)
    with tempfile.TemporaryDirectory() as name:
        report = Path(name, "report.xml")
        status = subprocess.run(
            [python, "-m", "pytest", "-q", f"--junitxml={report}", *options, *chosen],
            cwd=ROOT,
            env=python_environment(
                BLENDER_USER_RESOURCES=f"{name}/blender",
                # The checkout must not be importable by chance beside the installed zip.
                PYTHONSAFEPATH="1",
                **stage.variables,
            ),
            check=False,
        ).returncode
        return read_counts(report, status, stage.name)


def _take_paths(options: Sequence[str]) -> tuple[list[str], list[str]]:
    """Divide pytest's options into those that name tests of ours and the others."""
    named = [option for option in options if option.startswith("tests/")]
    return named, [option for option in options if option not in named]


def _is_in(test: str, folder: Path) -> bool:
    return (ROOT / test.partition("::")[0]).is_relative_to(folder)


def read_counts(report: Path, status: int, name: str) -> Counts:
    """Return the counts in pytest's JUnit report; a run that died counts as a failed test.

    Parameters
    ----------
    report : Path
        The report, which may be missing.
    status : int
        pytest's exit status.
    name : str
        What to call the run in warnings.
    """
    if not report.is_file():
        warn(f"{name}: pytest ended with status {status} before it reported")
        return Counts(failed=1)
    suites = ElementTree.parse(report).getroot().iter("testsuite")
    counts = Counts()
    for suite in suites:
        failed = int(suite.get("failures", 0)) + int(suite.get("errors", 0))
        skipped = int(suite.get("skipped", 0))
        counts.add(Counts(int(suite.get("tests", 0)) - failed - skipped, failed, skipped))
    if status == _PYTEST_NOTHING_SELECTED:
        warn(f"{name}: no test was selected")
    elif status and not counts.failed:
        # A crash after the last test: Blender ended the process while it was leaving.
        warn(f"{name}: pytest ended with status {status} though no test failed")
        counts.failed += 1
    return counts
