# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finding a CPython of a given version on this machine; on Debian, getting one."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from . import cpython, debian
from .console import say
from .errors import DevError
from .processes import python_environment

_PROBE = """
import importlib.util, json, struct, sys, sysconfig
print(json.dumps({
    "version": "%d.%d" % sys.version_info[:2],
    "usable": sys.implementation.name == "cpython" and struct.calcsize("P") == 8
        and not sysconfig.get_config_var("Py_GIL_DISABLED"),
    "makes_environments": all(importlib.util.find_spec(m) for m in ("venv", "ensurepip")),
}))
"""


def find_python(version: str) -> Path:
    """Return a CPython `version` ("3.11") that can make virtual environments.

    Raises
    ------
    DevError
        If there is none and none can be installed unattended; it names the command to run.
    """
    incomplete: Path | None = None
    for candidate in _candidates(version):
        facts = _probe(candidate)
        if facts is None or facts["version"] != version or not facts["usable"]:
            continue
        if facts["makes_environments"]:
            return candidate
        incomplete = incomplete or candidate
    if incomplete is not None and debian.is_debian():
        # Debian cuts ensurepip off into a package of its own.
        debian.ensure_packages([f"python{version}-venv"], f"making Python {version} environments")
        return incomplete
    if debian.is_debian() and debian.mirror():
        return _get_from_debian(version)
    raise DevError(_how_to_get(version))


def _candidates(version: str) -> Iterator[Path]:
    """Yield the places where a Python of this version may be, the likeliest first."""
    yield Path(sys.executable)
    yield cpython.built_python(version)
    on_path = shutil.which(f"python{version}")
    if on_path:
        yield Path(on_path)
    pyenv = Path(os.environ.get("PYENV_ROOT") or Path.home() / ".pyenv") / "versions"
    yield from sorted(pyenv.glob(f"{version}.*/bin/python"), reverse=True)
    uv = Path(os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share") / "uv"
    yield from sorted(
        (uv / "python").glob(f"cpython-{version}.*/bin/python{version}"), reverse=True
    )
    for folder in ("/usr/bin", "/usr/local/bin", "/opt/homebrew/bin"):
        yield Path(folder) / f"python{version}"
    launcher = shutil.which("py") if sys.platform == "win32" else None
    if launcher:
        listed = subprocess.run(
            [launcher, f"-{version}", "-c", "import sys; print(sys.executable)"],
            text=True,
            capture_output=True,
            check=False,
        )
        if listed.returncode == 0:
            yield Path(listed.stdout.strip())


def _probe(candidate: Path) -> dict[str, object] | None:
    """Ask an interpreter what it is; None if it does not run (as pyenv's shims may not)."""
    if not candidate.is_file():
        return None
    answer = subprocess.run(
        [str(candidate), "-c", _PROBE],
        text=True,
        capture_output=True,
        check=False,
        env=python_environment(),
    )
    return json.loads(answer.stdout) if answer.returncode == 0 else None


def _get_from_debian(version: str) -> Path:
    """Install Debian's own package of this Python, or build the sources of a suite that has it."""
    package = f"python{version}"
    if debian.is_root():
        debian.apt_update()
    known = subprocess.run(
        ["apt-cache", "policy", package], text=True, capture_output=True, check=False
    ).stdout
    if "Candidate:" in known and "Candidate: (none)" not in known:
        debian.ensure_packages([package, f"{package}-venv"], f"Python {version}")
        return Path("/usr/bin") / package
    say(f"Debian has no package {package} here: building it from the sources of a newer suite")
    return cpython.build_from_debian(version)


def _how_to_get(version: str) -> str:
    if sys.platform == "win32":
        command = f"winget install --exact --id Python.Python.{version}"
    elif sys.platform == "darwin":
        command = f"brew install python@{version}"
    elif shutil.which("pyenv"):
        command = f"pyenv install {version}"
    elif shutil.which("add-apt-repository"):  # Ubuntu
        command = (
            "sudo add-apt-repository -y ppa:deadsnakes/ppa && "
            f"sudo apt-get install -y python{version}-venv"
        )
    else:
        command = f"uv python install {version}"
    return (
        f"Python {version} is needed and not on this machine; run this command, then try again:"
        f"\n  {command}"
    )
