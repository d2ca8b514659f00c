# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""CPython built from Debian's own source packages, for a Python that the running Debian lacks.

Debian 12 has Python 3.11 only, but Blender 5.1 and newer need 3.13. The packages of a newer suite
want a newer C library, so the sources are built; they come from the mirror this machine uses.
"""

from __future__ import annotations

import os
import shutil
from pathlib import Path

from . import debian
from .console import step
from .errors import DevError
from .locking import exclusive
from .places import cache_folder
from .processes import run_quietly

_SUITES = {"3.11": "bookworm", "3.13": "trixie"}
_BUILD_PACKAGES = (
    *("gcc", "libc6-dev", "make", "xz-utils", "ca-certificates"),
    *("libssl-dev", "zlib1g-dev", "libffi-dev", "libbz2-dev", "liblzma-dev", "libsqlite3-dev"),
)


def built_python(version: str) -> Path:
    """Return where `build_from_debian` puts this Python, whether or not it has been built."""
    return _home(version) / "bin" / f"python{version}"


def build_from_debian(version: str) -> Path:
    """Build CPython `version` into the cache folder and return its interpreter.

    Raises
    ------
    DevError
        If no suite is known to have it, or if a step of the build fails.
    """
    suite = _SUITES.get(version)
    if suite is None:
        raise DevError(f"no Debian suite is known to have the sources of Python {version}")
    home = _home(version)
    with exclusive(home.with_name(f"{home.name}.lock")):
        if built_python(version).is_file():
            return built_python(version)
        debian.ensure_packages(_BUILD_PACKAGES, f"building Python {version}")
        work = home.with_name(f"{home.name}.partial")
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)
        with step(f"fetching the sources of Python {version} from Debian {suite}"):
            source = _unpack(_fetch(version, suite, work), work)
        with step(f"building Python {version}, once for this cache folder (some minutes)"):
            _build(source, home, work / "installed")
        shutil.rmtree(work)
    return built_python(version)


def _home(version: str) -> Path:
    return cache_folder() / "pythons" / f"cpython-{version}"


def _fetch(version: str, suite: str, work: Path) -> Path:
    """Download the source package with apt, which checks its signature and hashes."""
    for name in ("lists/partial", "archives/partial"):
        (work / name).mkdir(parents=True)
    sources = work / "sources.list"
    sources.write_text(f"deb-src {debian.mirror()} {suite} main\n", encoding="utf-8")
    # Lists and settings of its own, so that the machine's apt is left as it is. As root, apt would
    # otherwise fetch as a user who cannot write here.
    options = [
        f"-oDir::Etc::SourceList={sources}",
        "-oDir::Etc::SourceParts=/dev/null",
        f"-oDir::State::Lists={work / 'lists'}",
        f"-oDir::Cache={work}",
        "-oAPT::Sandbox::User=root",
    ]
    failure = f"fetching the sources of Python {version} failed"
    run_quietly(["apt-get", "-q", *options, "update"], failure)
    run_quietly(
        ["apt-get", "-q", *options, "--download-only", "source", f"python{version}"],
        failure,
        folder=work,
    )
    return next(work.glob("*.orig.tar.*z"))


def _unpack(archive: Path, work: Path) -> Path:
    target = work / "source"
    target.mkdir()
    run_quietly(["tar", "-xf", archive, "-C", target], f"unpacking {archive.name} failed")
    return next(target.iterdir())


def _build(source: Path, home: Path, staging: Path) -> None:
    """Build for `home`, install into `staging` and move the result into place in one rename."""
    failure = f"building {source.name} failed"
    jobs = str(os.cpu_count() or 1)
    # No link-time or profile-guided optimization: the tests do not gain what the build would cost.
    options = ["--with-ensurepip=no", "--disable-test-modules", "OPT=-O2 -DNDEBUG"]
    run_quietly(["./configure", f"--prefix={home}", *options], failure, folder=source)
    run_quietly(["make", "-j", jobs], failure, folder=source)
    run_quietly(["make", "install", f"DESTDIR={staging}"], failure, folder=source)
    (staging / home.relative_to(home.anchor)).rename(home)
