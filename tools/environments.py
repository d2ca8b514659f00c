# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Virtual environments made from the committed locks, in the cache folder, keyed by their lock.

A second clone finds them there. A changed lock makes a new one beside the old.
"""

from __future__ import annotations

import concurrent.futures
import hashlib
import shutil
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from . import debian
from .blenders import BLENDERS
from .console import step
from .errors import DevError
from .interpreters import find_python
from .locking import exclusive
from .places import LOCKS, cache_folder
from .processes import python_environment, run_quietly


@dataclass(frozen=True)
class Environment:
    """What an environment holds, before `dev.py lock` turns it into pins and hashes."""

    name: str
    python: str
    requirements: tuple[str, ...]

    @property
    def lock(self) -> Path:
        """The committed lock file."""
        return LOCKS / f"{self.name}.txt"

    @property
    def needs_bpy_libraries(self) -> bool:
        """Whether Blender's system libraries must be there."""
        return self.name.startswith("bpy-")


# No libigl or scipy for bpy: there they must come from the wheels in the installed zip.
ENVIRONMENTS = {
    environment.name: environment
    for environment in (
        Environment(
            "geometry",
            python="3.11",
            requirements=(
                *("numpy==1.26.4", "scipy==1.15.3", "libigl==2.6.3"),
                *("pytest", "hypothesis"),
            ),
        ),
        # The peers that the benchmarks compare with.
        Environment(
            "benchmark",
            python="3.11",
            requirements=(
                *("numpy==1.26.4", "scipy==1.15.3", "libigl==2.6.3"),
                *("pyvista", "pymeshlab", "trimesh", "rtree", "matplotlib"),
            ),
        ),
        # Later stubs of Blender 4.2 confuse properties with methods (seen in 20260730).
        # basedpyright is pyright with its Node.js in a wheel: no download at run time.
        Environment(
            "check",
            python="3.11",
            requirements=(
                *("ruff", "basedpyright", "fake-bpy-module-4.2==20250130"),
                *("numpy==2.3.4", "scipy==1.15.3", "scipy-stubs==1.15.3.*", "libigl==2.6.3"),
                *("pytest", "hypothesis", "pillow"),
            ),
        ),
        *(
            Environment(
                blender.environment,
                python=blender.python,
                requirements=(f"bpy=={blender.bpy}", f"numpy=={blender.numpy}", "pytest"),
            )
            for blender in BLENDERS.values()
        ),
    )
}


def ensure(name: str) -> Path:
    """Return the interpreter of an environment, which is made first if it is missing.

    Parameters
    ----------
    name : str
        A key of `ENVIRONMENTS`.

    Raises
    ------
    DevError
        If its lock, its Python or a system library is missing, or a package cannot be installed.
    """
    environment = ENVIRONMENTS[name]
    if not environment.lock.is_file():
        raise DevError(f"{environment.lock} is missing; `python3 dev.py lock` writes it")
    if environment.needs_bpy_libraries and debian.is_debian():
        debian.ensure_packages(debian.BPY_LIBRARIES, "Blender's bpy module")
    folder = folder_of(environment)
    python = interpreter(folder)
    complete = folder / "complete"
    if complete.is_file():
        return python
    with exclusive(folder.with_name(f"{folder.name}.lock")):
        if complete.is_file():
            return python
        shutil.rmtree(folder, ignore_errors=True)
        base = find_python(environment.python)
        with step(f"making environment {name} with Python {environment.python}"):
            _make(environment, base, folder)
        # Written last: a folder without it was interrupted and is made anew.
        complete.write_text(f"{environment.lock.name}\n", encoding="utf-8")
    return python


def ensure_all(names: Sequence[str]) -> None:
    """Make several environments, two at a time: one downloads while the other unpacks."""
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        for made in [pool.submit(ensure, name) for name in names]:
            made.result()


def interpreter(folder: Path) -> Path:
    """Return the interpreter inside an environment's folder."""
    return (
        folder / "Scripts" / "python.exe" if sys.platform == "win32" else folder / "bin" / "python"
    )


def site_packages(python: Path) -> Path:
    """Return the folder into which an environment's packages were installed."""
    found = run_quietly(
        [python, "-c", "import sysconfig; print(sysconfig.get_path('platlib'))"],
        f"{python} does not start",
        environment=python_environment(),
    )
    return Path(found.strip())


def folder_of(environment: Environment) -> Path:
    """Return where an environment lies in the cache folder, whether or not it has been made."""
    key = hashlib.sha256(environment.lock.read_bytes() + environment.python.encode()).hexdigest()
    return cache_folder() / "environments" / f"{environment.name}-{key[:12]}"


def _make(environment: Environment, base: Path, folder: Path) -> None:
    failure = f"making environment {environment.name} failed"
    clean = python_environment()
    run_quietly([base, "-m", "venv", folder], failure, environment=clean)
    run_quietly(
        [
            *(
                interpreter(folder),
                "-m",
                "pip",
                "install",
                "--quiet",
                "--disable-pip-version-check",
            ),
            # The lock is complete, so nothing is resolved; no build scripts of strangers are run.
            *("--no-deps", "--only-binary=:all:", "--require-hashes"),
            *("-r", environment.lock),
        ],
        failure,
        environment=clean,
    )
    if environment.needs_bpy_libraries:
        run_quietly(
            [interpreter(folder), "-c", "import bpy"],
            "Blender's bpy module does not start; if a library is missing, install it with the "
            "package manager of this system",
            environment=clean,
        )
