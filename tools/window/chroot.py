# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A Debian with a windowed Blender and a virtual screen, in a folder of the cache.

Nothing is mounted into it, so that deleting it can harm nothing else: files are copied in and out.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

from .. import debian
from ..console import step
from ..errors import DevError
from ..locking import exclusive
from ..places import cache_folder
from ..processes import run_quietly

SUITES = ("trixie", "sid")
_PACKAGES = (
    # Debian's Blender does not pull what an official one carries: numpy, requests, cattrs.
    *("blender", "python3-numpy", "python3-requests", "python3-cattr"),
    *("xvfb", "x11-utils", "xdotool", "imagemagick", "libgl1-mesa-dri", "libegl1"),
    *("python3-pytest", "python3-pil"),
)
_FILES = {
    # Mirrors of sid may lag behind.
    "etc/apt/apt.conf.d/99lag": 'Acquire::Check-Valid-Until "false";\n',
    "etc/dpkg/dpkg.cfg.d/fast": "force-unsafe-io\n",
    # Packages must not start services here.
    "usr/sbin/policy-rc.d": "#!/bin/sh\nexit 101\n",
    # Without it Blender warns on stdout, where commands print their results.
    "etc/mtab": "rootfs / rootfs rw 0 0\n",
}


def reason_against() -> str | None:
    """Return why no such folder can be made on this machine; None if it can."""
    if not sys.platform.startswith("linux") or not debian.is_debian():
        return "this is not Debian"
    if not debian.is_root():
        return "only root may make a chroot"
    if not debian.mirror():
        return "no Debian mirror is named in /etc/apt"
    return None


def folder_of(suite: str) -> Path:
    """Return where a suite's chroot lies in the cache folder, whether or not it has been made."""
    recipe = "\n".join([*_PACKAGES, *_FILES, *_FILES.values()])
    key = hashlib.sha256(recipe.encode()).hexdigest()[:12]
    return cache_folder() / "chroots" / f"{suite}-{key}"


def ensure_chroot(suite: str) -> Path:
    """Return the folder of a Debian suite with Blender in it, which is made if it is missing.

    Raises
    ------
    DevError
        If debootstrap or apt fails.
    """
    folder = folder_of(suite)
    complete = folder / "complete"
    if complete.is_file():
        return folder
    with exclusive(folder.with_name(f"{folder.name}.lock")):
        if not complete.is_file():
            debian.ensure_packages(["debootstrap", "ca-certificates"], "making a chroot")
            delete(folder)
            with step(f"making a chroot of Debian {suite} with its Blender"):
                _make(suite, folder)
            complete.touch()
    return folder


def inside(folder: Path, *command: str) -> list[str]:
    """Return the command line that runs a program in the chroot, free of the caller's settings."""
    settings = ["PATH=/usr/sbin:/usr/bin:/sbin:/bin", "HOME=/root", "LANG=C.UTF-8"]
    # Without its proxy, apt may reach nothing.
    settings += [f"{name}={value}" for name, value in os.environ.items() if name.endswith("_proxy")]
    return ["chroot", str(folder), "/usr/bin/env", "-i", *settings, *command]


def versions(folder: Path) -> tuple[str, str]:
    """Return the versions of Blender and of Python in the chroot, such as ("4.3", "3.13")."""
    words = run_quietly(inside(folder, "blender", "--version"), "Blender does not start").split()
    python = run_quietly(
        inside(folder, "python3", "-c", "import sys; print('%d.%d' % sys.version_info[:2])"),
        "Python does not start",
    )
    return ".".join(words[1].split(".")[:2]), python.strip()


def _make(suite: str, folder: Path) -> None:
    mirror = debian.mirror() or ""
    failure = f"making a chroot of Debian {suite} failed"
    run_quietly(["debootstrap", "--variant=minbase", suite, folder, mirror], failure)
    for name in ("resolv.conf", "hosts"):
        shutil.copy(Path("/etc", name), folder / "etc" / name)
    for name, text in {"etc/apt/sources.list": f"deb {mirror} {suite} main\n", **_FILES}.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)  # it may be a link out of the folder
        path.write_text(text, encoding="utf-8")
    (folder / "usr/sbin/policy-rc.d").chmod(0o755)
    apt = inside(folder, "DEBIAN_FRONTEND=noninteractive", "apt-get", "-y", "-q")
    run_quietly([*apt, "update"], failure)
    run_quietly([*apt, "install", "--no-install-recommends", *_PACKAGES], failure)
    run_quietly([*apt, "clean"], failure)
    # debootstrap leaves its /proc mounted in some environments.
    subprocess.run(["umount", folder / "proc"], check=False, capture_output=True)


def delete(folder: Path) -> None:
    """Delete a chroot, but never what is mounted into it."""
    mounts = Path("/proc/mounts").read_text(encoding="utf-8").splitlines()
    mounted = [
        line.split()[1] for line in mounts if line.split()[1].startswith(f"{folder}{os.sep}")
    ]
    for place in reversed(mounted):
        run_quietly(["umount", place], f"{place} is mounted and cannot be unmounted")
    if any(Path(place).is_mount() for place in mounted):
        raise DevError(f"something is still mounted in {folder}: unmount it and try again")
    shutil.rmtree(folder, ignore_errors=True)
