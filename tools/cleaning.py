# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Deleting what dev.py made: results in the checkout, and what the cache no longer needs."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

from . import environments, wheels
from .console import say
from .places import DIST, OUT, cache_folder
from .window import chroot


def clean(*, whole_cache: bool) -> None:
    """Delete dist/ and out/, and from the cache folder what no lock of this checkout names.

    Parameters
    ----------
    whole_cache : bool
        Delete everything in the cache folder, so that the next command starts from nothing.
    """
    current = {chroot.folder_of(suite) for suite in chroot.SUITES}
    for folder in (cache_folder() / "chroots").glob("*/"):
        if whole_cache or folder not in current:
            say(f"deleting {folder}")
            chroot.delete(folder)
    targets = [DIST, OUT]
    targets += cache_folder().iterdir() if whole_cache else _outdated()
    for path in targets:
        if path.is_dir():
            say(f"deleting {path}")
            shutil.rmtree(path)
        else:
            path.unlink(missing_ok=True)


def _outdated() -> Iterator[Path]:
    """Yield environments and wheels of other locks; another checkout may have to remake them."""
    kept = {environments.folder_of(one) for one in environments.ENVIRONMENTS.values()}
    for folder in (cache_folder() / "environments").glob("*/"):
        if folder not in kept:
            yield folder
    used = {wheel.cached.parent for wheel in wheels.table()}
    for folder in (cache_folder() / "wheels").glob("*/"):
        if folder not in used:
            yield folder
