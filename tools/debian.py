# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""System packages on Debian and its kin: installed as root, asked for otherwise."""

from __future__ import annotations

import functools
import os
import re
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

from .console import step
from .errors import DevError
from .processes import run_quietly

# bpy links the first group when it is imported; without libegl1 the first render ends the process.
BPY_LIBRARIES = (
    *("libx11-6", "libxrender1", "libxxf86vm1", "libxfixes3", "libxi6", "libxkbcommon0"),
    *("libsm6", "libice6", "libxext6", "libgl1", "libgl1-mesa-dri", "libgomp1"),
    "libegl1",
)


def is_debian() -> bool:
    """Tell whether packages are managed by apt and dpkg here."""
    return bool(shutil.which("apt-get") and shutil.which("dpkg-query"))


def is_root() -> bool:
    """Tell whether packages may be installed; never the case on Windows."""
    return hasattr(os, "geteuid") and os.geteuid() == 0


def missing_packages(packages: Sequence[str]) -> list[str]:
    """Return those packages that dpkg does not know as installed."""
    listing = subprocess.run(
        ["dpkg-query", "-W", "-f", "${Package} ${db:Status-Status}\n", *packages],
        text=True,
        capture_output=True,
        check=False,  # its status is 1 as soon as one package is unknown
    ).stdout
    installed = {line.split()[0] for line in listing.splitlines() if line.endswith(" installed")}
    return [package for package in packages if package not in installed]


def ensure_packages(packages: Sequence[str], purpose: str) -> None:
    """Install what is missing of `packages`, or say which command does.

    Raises
    ------
    DevError
        If packages are missing and this is not root.
    """
    missing = missing_packages(packages)
    if not missing:
        return
    if not is_root():
        raise DevError(
            f"{purpose} needs system packages that are not installed; run this command, then try "
            f"again:\n  sudo apt-get install --no-install-recommends {' '.join(missing)}"
        )
    with step(f"installing {len(missing)} Debian packages for {purpose} ({' '.join(missing)})"):
        apt_update()
        apt("install", "--no-install-recommends", *missing)


@functools.lru_cache(maxsize=1)
def apt_update() -> None:
    """Fetch the package lists, once per run of dev.py."""
    apt("update")


def apt(*arguments: str) -> None:
    """Run apt-get unattended, waiting for another apt-get that holds the lock."""
    run_quietly(
        ["apt-get", "-y", "-q", "-o", "DPkg::Lock::Timeout=300", *arguments],
        f"apt-get {arguments[0]} failed",
        environment={**os.environ, "DEBIAN_FRONTEND": "noninteractive"},
    )


def mirror() -> str | None:
    """Return the Debian mirror in this machine's own apt settings; None on Ubuntu and the like."""
    settings = [Path("/etc/apt/sources.list"), *Path("/etc/apt/sources.list.d").glob("*")]
    texts = [path.read_text(encoding="utf-8") for path in settings if path.is_file()]
    entries = re.findall(
        r"^(?:URIs:|deb(?: \[.*?\])?)\s*(\S+/debian)/?\s*(?:$|\s)", "\n".join(texts), re.M
    )
    return entries[0] if entries else None
