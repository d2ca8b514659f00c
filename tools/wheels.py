# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheels in the zips: read from the committed table, fetched, checked, repacked, cached."""

from __future__ import annotations

import concurrent.futures
import hashlib
import shutil
import tempfile
import tomllib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from . import environments, repack
from .console import step
from .errors import DevError
from .locking import exclusive
from .places import LOCKS, cache_folder
from .processes import python_environment, run_quietly
from .wheel_sources import PIP_PLATFORMS

TABLE = LOCKS / "wheels.toml"


@dataclass(frozen=True)
class Wheel:
    """One row of the table: a file on the package index, and what we make of it."""

    file: str
    sha256: str
    requirement: str
    pythons: tuple[str, ...]
    platform: str
    repacked: str | None = None
    repacked_sha256: str | None = None

    @property
    def shipped(self) -> str:
        """The file name that goes into the zip and its manifest."""
        return self.repacked or self.file

    @property
    def shipped_sha256(self) -> str:
        """The hash of the file that goes into the zip."""
        return self.repacked_sha256 or self.sha256

    @property
    def cached(self) -> Path:
        """Where the file lies once it has been fetched and checked."""
        return cache_folder() / "wheels" / self.shipped_sha256[:16] / self.shipped


def table() -> list[Wheel]:
    """Return all rows of the committed table."""
    with TABLE.open("rb") as handle:
        rows = tomllib.load(handle)["wheel"]
    return [Wheel(**{**row, "pythons": tuple(row["pythons"])}) for row in rows]


def select(python: str, platform: str) -> list[Wheel]:
    """Return the wheels for one CPython and platform.

    Raises
    ------
    DevError
        If the table has none.
    """
    found = [w for w in table() if python in w.pythons and w.platform == platform]
    if not found:
        raise DevError(f"{TABLE.name} has no wheels for Python {python} on {platform}")
    return found


def fetch(wanted: Iterable[Wheel]) -> list[Path]:
    """Return the paths of wheels, in the order given; those not in the cache are fetched first.

    Raises
    ------
    DevError
        If a file cannot be had or does not have the hash in the table.
    """
    wanted = list(wanted)
    missing = [wheel for wheel in wanted if not wheel.cached.is_file()]
    if missing:
        with exclusive(cache_folder() / "wheels.lock"):
            # Another run may have fetched them while this one waited.
            missing = [wheel for wheel in missing if not wheel.cached.is_file()]
            _fetch_missing(missing)
    return [wheel.cached for wheel in wanted]


def _fetch_missing(missing: Sequence[Wheel]) -> None:
    python = environments.ensure("geometry")
    with (
        step(f"fetching {len(missing)} wheels for the extension"),
        concurrent.futures.ThreadPoolExecutor(max_workers=3) as pool,
    ):
        for done in [pool.submit(_fetch_one, wheel, python) for wheel in missing]:
            done.result()


def _fetch_one(wheel: Wheel, python: Path) -> None:
    with tempfile.TemporaryDirectory(dir=cache_folder()) as name:
        folder = Path(name)
        original = download(python, folder, wheel.requirement, wheel.pythons[0], wheel.platform)
        expect_hash(original, wheel.sha256)
        if wheel.repacked:
            shipped = repack.repack(original, folder / "repacked")
            if shipped.name != wheel.repacked or sha256(shipped) != wheel.repacked_sha256:
                raise DevError(
                    f"repacking {wheel.file} gave {shipped.name} with another hash than the table "
                    "has: run `python3 dev.py lock` if tools/repack.py was changed on purpose"
                )
        else:
            shipped = original
        wheel.cached.parent.mkdir(parents=True, exist_ok=True)
        shutil.move(shipped, wheel.cached)


def download(python: Path, folder: Path, requirement: str, version: str, platform: str) -> Path:
    """Let pip download the one wheel of `requirement` for a CPython version and platform."""
    tags = [word for tag in PIP_PLATFORMS[platform] for word in ("--platform", tag)]
    run_quietly(
        [
            *(python, "-m", "pip", "download", "--quiet", "--disable-pip-version-check"),
            *("--no-deps", "--only-binary=:all:", "--implementation", "cp"),
            *("--python-version", version, *tags, "--dest", folder, requirement),
        ],
        f"downloading {requirement} for Python {version} on {platform} failed",
        environment=python_environment(),
    )
    return next(folder.glob("*.whl"))


def expect_hash(path: Path, expected: str) -> None:
    """Raise `DevError` unless a file has the SHA-256 that the table gives."""
    found = sha256(path)
    if found != expected:
        raise DevError(f"{path.name} has SHA-256 {found}, but {TABLE.name} expects {expected}")


def sha256(path: Path) -> str:
    """Return the SHA-256 of a file in hexadecimal digits."""
    return hashlib.sha256(path.read_bytes()).hexdigest()
