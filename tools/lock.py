# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writing the lock files: every package pinned, with the hashes of its files for all platforms.

Run by whoever changes a requirement. The locks name no index, so a mirror in pip's settings works.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from .console import step
from .environments import ENVIRONMENTS, Environment, interpreter
from .interpreters import find_python
from .processes import python_environment, run_quietly

_LOCKER = "uv==0.13.9"


def write_locks() -> None:
    """Resolve every environment's requirements to the newest versions and write its lock."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        clean = python_environment()
        with step(f"installing {_LOCKER} for the time of locking"):
            run_quietly(
                [find_python("3.11"), "-m", "venv", folder], "no environment", environment=clean
            )
            python = interpreter(folder)
            run_quietly(
                [python, "-m", "pip", "install", "--quiet", _LOCKER], "no uv", environment=clean
            )
        for environment in ENVIRONMENTS.values():
            with step(f"locking {environment.name}"):
                environment.lock.write_text(_resolve(python, environment), encoding="utf-8")


def _resolve(python: Path, environment: Environment) -> str:
    pins = run_quietly(
        [
            *(python, "-m", "uv", "pip", "compile", "--quiet", "--universal", "--generate-hashes"),
            *("--no-header", "--no-annotate", "--no-emit-index-url", "--no-emit-find-links"),
            *("--only-binary", ":all:", "--python-version", environment.python, "-"),
        ],
        f"locking {environment.name} failed",
        environment=python_environment(),
        text_input="\n".join(environment.requirements),
    )
    wanted = ", ".join(environment.requirements)
    return f"# Written by dev.py lock for Python {environment.python}: {wanted}\n{pins}"
