# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Registration of everything that the extension adds to Blender."""

from __future__ import annotations

from contextlib import ExitStack

from .. import operators
from . import cli, handlers, overlay, panels, presets, properties

_MODULES = (properties, presets, operators, panels, overlay, handlers, cli)
_registered = ExitStack()


def register() -> None:
    """Register every module, or none: a failure undoes the ones before it."""
    with ExitStack() as stack:
        for module in _MODULES:
            module.register()
            stack.callback(module.unregister)
        _registered.push(stack.pop_all())


def unregister() -> None:
    """Undo `register` in reverse order."""
    _registered.close()
