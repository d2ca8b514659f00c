# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs beside a windowed Blender: starts the screen and Blender, takes pictures, moves the mouse.

Blender cannot take a picture of itself here (its screenshot operator gives a black one), and
simulated events would make it deaf to real ones: both are done from outside when `player` asks.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

SCREEN_SIZE = (1600, 1200)
_HERE = Path(__file__).resolve().parent
_TIME_LIMIT = 300.0
_POLL_SECONDS = 0.02


def install(zip_file: Path, user: Path, log: Path) -> None:
    """Install and enable the extension by Blender's command line, as the README says."""
    command = ["extension", "install-file", "--repo", "user_default", "--enable", str(zip_file)]
    with log.open("w", encoding="utf-8") as output:
        subprocess.run(
            ["blender", "--command", *command],
            env=_environment(user),
            stdout=output,
            stderr=subprocess.STDOUT,
            check=True,
        )


def play(scenario: Path, arguments: list[str], user: Path, results: Path) -> int:
    """Play a scenario in a windowed Blender and return Blender's exit status.

    Parameters
    ----------
    scenario : Path
        A Python file with a generator function `scenario`, see `session`.
    arguments : list of str
        Passed to that function.
    user : Path
        Blender's user folder, into which the extension has been installed.
    results : Path
        An empty folder for pictures, `result.json` and `blender.log`.
    """
    with _screen(results) as display, (results / "blender.log").open("w", encoding="utf-8") as log:
        width, height = (str(size) for size in SCREEN_SIZE)
        blender = subprocess.Popen(
            [
                *("blender", "--offline-mode", "--window-geometry", "0", "0", width, height),
                *("--python-exit-code", "1", "--python", str(_HERE / "player.py")),
                *("--", str(scenario), str(results), *arguments),
            ],
            env={**_environment(user), "DISPLAY": display},
            stdout=log,
            stderr=subprocess.STDOUT,
        )
        end = time.monotonic() + _TIME_LIMIT
        while blender.poll() is None:
            if time.monotonic() > end:
                blender.kill()
            _answer(results, display)
            time.sleep(_POLL_SECONDS)
        return blender.returncode


def _environment(user: Path) -> dict[str, str]:
    return {**os.environ, "BLENDER_USER_RESOURCES": str(user)}


@contextmanager
def _screen(results: Path) -> Iterator[str]:
    """Start a virtual screen of its own; Xvfb itself chooses a free number."""
    reading, writing = os.pipe()
    width, height = SCREEN_SIZE
    with (results / "screen.log").open("w", encoding="utf-8") as log:
        screen = subprocess.Popen(
            [
                *("Xvfb", "-displayfd", str(writing), "-nolisten", "tcp"),
                *("-screen", "0", f"{width}x{height}x24"),
            ],
            pass_fds=[writing],
            stdout=log,
            stderr=subprocess.STDOUT,
        )
    os.close(writing)
    try:
        with os.fdopen(reading) as pipe:
            yield f":{pipe.readline().strip()}"
    finally:
        screen.terminate()
        screen.wait()


def _answer(results: Path, display: str) -> None:
    """Do what the session asks for in `request.json`; its disappearing is the answer."""
    request = results / "request.json"
    if not request.exists():
        return
    asked = json.loads(request.read_text(encoding="utf-8"))
    environment = {**os.environ, "DISPLAY": display}
    if "shot" in asked:
        command = ["import", "-window", "root", str(results / f"{asked['shot']}.png")]
        subprocess.run(command, env=environment, check=True)
    else:
        subprocess.run(["xdotool", *asked["xdotool"]], env=environment, check=True)
    request.unlink()


if __name__ == "__main__":
    sys.exit("this module is used by tests/window/conftest.py")
