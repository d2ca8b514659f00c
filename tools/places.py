# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where things lie: in the checkout, and in the cache folder that all checkouts of a user share."""

from __future__ import annotations

import os
import sys
from pathlib import Path

CACHE_VARIABLE = "ARCHITECTURAL_CURVATURE_CACHE"

ROOT = Path(__file__).resolve().parent.parent
DIST = ROOT / "dist"
OUT = ROOT / "out"
LOCKS = ROOT / "tools" / "locks"


def cache_folder() -> Path:
    """Return the per-user cache folder, made if it is missing.

    The environment variable `ARCHITECTURAL_CURVATURE_CACHE` names it; otherwise it follows the
    platform: `~/.cache` (or `XDG_CACHE_HOME`), `~/Library/Caches`, `%LOCALAPPDATA%`.
    """
    named = os.environ.get(CACHE_VARIABLE)
    if named:
        folder = Path(named).expanduser().resolve()
    elif sys.platform == "win32":
        local = os.environ.get("LOCALAPPDATA") or str(Path.home() / "AppData" / "Local")
        folder = Path(local) / "architectural-curvature"
    elif sys.platform == "darwin":
        folder = Path.home() / "Library" / "Caches" / "architectural-curvature"
    else:
        base = os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
        folder = Path(base) / "architectural-curvature"
    folder.mkdir(parents=True, exist_ok=True)
    return folder
