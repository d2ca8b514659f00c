# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The checkout's geometry and exact surfaces, importable outside Blender."""

from __future__ import annotations

import importlib
import importlib.util
import sys
from pathlib import Path
from types import ModuleType

ROOT = Path(__file__).resolve().parents[2]
_PACKAGE = "architectural_curvature"


def geometry(name: str) -> ModuleType:
    """Return a module of addon/geometry, such as "curvature" or "engine.estimator"."""
    if _PACKAGE not in sys.modules:
        spec = importlib.util.spec_from_file_location(
            _PACKAGE, ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
        )
        if spec is None or spec.loader is None:
            raise ImportError(f"{ROOT} is no package")
        package = importlib.util.module_from_spec(spec)
        sys.modules[_PACKAGE] = package
        spec.loader.exec_module(package)
    return importlib.import_module(f"{_PACKAGE}.addon.geometry.{name}")


def surfaces(name: str) -> ModuleType:
    """Return a module of tests/surfaces, such as "catalogue"."""
    return tests(f"surfaces.{name}")


def tests(name: str) -> ModuleType:
    """Return a module of the folder tests that is no test itself, such as "solids"."""
    folder = str(ROOT / "tests")
    if folder not in sys.path:
        sys.path.append(folder)
    return importlib.import_module(name)
