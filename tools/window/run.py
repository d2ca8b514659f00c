# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The `window` command: prepare the chroot, copy zip and tests in, run them, copy pictures out."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

from .. import build
from ..console import say, step, warn
from ..places import OUT, ROOT
from ..testing import Counts, read_counts
from . import chroot

_INSIDE = Path(__file__).parent / "inside"


def run(suite: str, options: Sequence[str]) -> int:
    """Run tests/window in the Blender of a Debian suite and print the closing line.

    Parameters
    ----------
    suite : str
        The Debian suite, such as "trixie".
    options : sequence of str
        Passed on to pytest.

    Returns
    -------
    int
        0 if nothing failed, also where no chroot can be made; 1 otherwise.
    """
    reason = chroot.reason_against()
    if reason:
        warn(f"NOT TESTED IN A WINDOW: {reason}")
        print(Counts(skipped=1), flush=True)
        return 0
    folder = chroot.ensure_chroot(suite)
    blender, python = chroot.versions(folder)
    say(f"Debian {suite} has Blender {blender} with Python {python}")
    zip_file = build.build_for_tests(python, blender)
    with step(f"testing in the window of Blender {blender}"):
        counts = _run_tests(folder, zip_file, options)
    print(counts, flush=True)
    return 0 if counts.passed and not counts.failed else 1


def _run_tests(folder: Path, zip_file: Path, options: Sequence[str]) -> Counts:
    with tempfile.TemporaryDirectory(dir=folder / "tmp", prefix="window-") as name:
        session = Path(name)
        shutil.copy(zip_file, session / "extension.zip")
        shutil.copytree(_INSIDE, session / "inside")
        shutil.copytree(ROOT / "tests" / "window", session / "tests" / "window")
        shutil.copytree(ROOT / "assets", session / "assets")
        status = subprocess.run(
            [
                *chroot.inside(folder, "/bin/sh", "-c", 'cd "$0" && exec "$@"'),
                *(f"/tmp/{session.name}", "python3", "-m", "pytest", "-q", "--rootdir=."),  # noqa: S108 - inside the chroot
                *("-p", "no:cacheprovider", "--junitxml=report.xml", *options, "tests/window"),
            ],
            check=False,
        ).returncode
        _copy_out(session / "out")
        return read_counts(session / "report.xml", status, "window")


def _copy_out(results: Path) -> None:
    target = OUT / "window"
    shutil.rmtree(target, ignore_errors=True)
    if results.is_dir():
        shutil.copytree(results, target)
        say(f"screenshots and logs are in {target.relative_to(ROOT)}")
