# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension's version, from the one place where it is written."""

from __future__ import annotations

import tomllib
from functools import cache
from importlib import resources

from .. import __package__ as base_package


@cache
def extension_version() -> str:
    """Return the version in the extension's manifest."""
    manifest = resources.files(base_package).joinpath("blender_manifest.toml")
    return tomllib.loads(manifest.read_text(encoding="utf-8"))["version"]
