# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Running other programs: output kept back when all goes well, shown when it does not."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

from .errors import DevError

_SHOWN_LINES = 30


def run_quietly(
    command: Sequence[str | Path],
    failure: str,
    *,
    environment: Mapping[str, str] | None = None,
    folder: Path | None = None,
    text_input: str | None = None,
) -> str:
    """Run a command and return its stdout.

    Parameters
    ----------
    command : sequence of str or Path
        The program and its arguments.
    failure : str
        What to say if it fails, followed by the end of its output.
    environment : mapping, optional
        The complete environment; the current one by default.
    folder : Path, optional
        Working folder.
    text_input : str, optional
        Fed to its stdin, which is empty otherwise.

    Raises
    ------
    DevError
        If the program is missing or ends with another status than 0.
    """
    words = [str(word) for word in command]
    try:
        finished = subprocess.run(
            words,
            env=environment,
            cwd=folder,
            input=text_input or "",
            text=True,
            encoding="utf-8",
            errors="replace",
            capture_output=True,
            check=False,
        )
    except FileNotFoundError:
        raise DevError(f"{failure}: there is no program {words[0]}") from None
    if finished.returncode:
        lines = (finished.stdout + finished.stderr).rstrip().splitlines()
        shown = "\n".join(lines[-_SHOWN_LINES:])
        raise DevError(f"{failure}: {words[0]} ended with status {finished.returncode}\n{shown}")
    return finished.stdout


def python_environment(**extra: str) -> dict[str, str]:
    """Return the environment for a Python of ours, free of the caller's own Python settings."""
    kept = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "VIRTUAL_ENV"))}
    kept.update(PYTHONNOUSERSITE="1", PYTHONDONTWRITEBYTECODE="1", PYTHONUTF8="1")
    kept.update(extra)
    return kept
