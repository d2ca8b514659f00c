# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Format, lint rules and types of the whole repository."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from . import environments
from .console import say, step
from .places import OUT, ROOT
from .processes import python_environment


def check() -> int:
    """Run every check, also after one has failed, and return 0 if all are clean."""
    python = environments.ensure("check")
    commands = {
        "format": ("ruff", "format", "--check", "."),
        "lint": ("ruff", "check", "."),
        # It finds the stubs of Blender, numpy and scipy through the interpreter named to it.
        "types": ("basedpyright", "--project", "pyproject.toml", "--pythonpath", str(python)),
    }
    _name_the_package()
    failed = []
    for name, command in commands.items():
        with step(f"checking {name}"):
            if _run(python, *command):
                failed.append(name)
    say(f"not clean: {', '.join(failed)}" if failed else "format, lint and types are clean")
    return 1 if failed else 0


def _name_the_package() -> None:
    """Make the checkout, whatever its folder is called, known to the type checker by its name.

    Tests import from `architectural_curvature`; pyproject.toml has the link's folder in extraPaths.
    """
    link = OUT / "typing" / "architectural_curvature"
    link.parent.mkdir(parents=True, exist_ok=True)
    if link.exists():
        return
    if sys.platform == "win32":
        # Unlike symbolic links, junctions need no privilege.
        import _winapi

        _winapi.CreateJunction(str(ROOT), str(link))
    else:
        link.symlink_to(ROOT, target_is_directory=True)


def format_sources() -> int:
    """Sort the imports of all sources and format them, in place."""
    python = environments.ensure("check")
    sorting = _run(python, "ruff", "check", "--select", "I", "--fix", "--quiet", ".")
    return max(sorting, _run(python, "ruff", "format", "."))


def _run(python: Path, *command: str) -> int:
    return subprocess.run(
        [python, "-m", *command], cwd=ROOT, env=python_environment(), check=False
    ).returncode
