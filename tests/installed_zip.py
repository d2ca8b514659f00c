# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension as a user has it: the built zip, installed into the bpy module.

`architectural_curvature` becomes another name of the installed package, so that tests in Blender
and tests in plain Python import in the same way.
"""

import importlib
import importlib.abc
import importlib.machinery
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from types import ModuleType

import bpy

REPOSITORY = "user_default"
INSTALLED_PACKAGE = f"bl_ext.{REPOSITORY}.architectural_curvature"


class _Alias(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Finds `alias` and its submodules as the very modules of the installed package."""

    def __init__(self, alias: str) -> None:
        self._alias = alias

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> importlib.machinery.ModuleSpec | None:
        """Claim the alias and what is below it."""
        del path, target
        if fullname != self._alias and not fullname.startswith(f"{self._alias}."):
            return None
        return importlib.machinery.ModuleSpec(fullname, self, is_package=True)

    def create_module(self, spec: importlib.machinery.ModuleSpec) -> None:
        """Leave it to Python to make a module that `exec_module` throws away."""
        del spec

    def exec_module(self, module: ModuleType) -> None:
        """Put the installed module in place of the new one, which Python's import allows."""
        real = INSTALLED_PACKAGE + module.__name__.removeprefix(self._alias)
        sys.modules[module.__name__] = importlib.import_module(real)


def install_and_alias(zip_file: Path, alias: str) -> None:
    """Install and enable a zip, and make it importable as `alias`.

    Parameters
    ----------
    zip_file : Path
        The zip that `dev.py build` made for this Blender.
    alias : str
        The name under which tests import the package.

    Raises
    ------
    RuntimeError
        If Blender's user folder was not set, or if Blender does not enable the extension.
    """
    if "BLENDER_USER_RESOURCES" not in os.environ:
        message = "BLENDER_USER_RESOURCES must name a temporary folder: yours would be changed"
        raise RuntimeError(message)
    install(zip_file)
    if INSTALLED_PACKAGE not in bpy.context.preferences.addons:
        message = f"Blender {bpy.app.version_string} did not enable {zip_file.name}"
        raise RuntimeError(message)
    sys.meta_path.insert(0, _Alias(alias))


def install(zip_file: Path) -> None:
    """Install and enable a zip, as dragging it into Blender does."""
    bpy.ops.extensions.package_install_files(
        filepath=os.fspath(zip_file), repo=REPOSITORY, enable_on_install=True
    )


def reset_scene() -> None:
    """Open Blender's empty factory file; preferences and the enabled extension stay."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    if INSTALLED_PACKAGE not in bpy.context.preferences.addons:
        import addon_utils

        addon_utils.enable(INSTALLED_PACKAGE, default_set=True)
