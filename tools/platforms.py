# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The platform that this machine is, in Blender's words."""

from __future__ import annotations

import platform
import sys

from .blenders import PLATFORMS
from .errors import DevError

_SYSTEMS = {"linux": "linux", "win32": "windows", "darwin": "macos"}
_MACHINES = {"x86_64": "x64", "amd64": "x64", "arm64": "arm64", "aarch64": "arm64"}


def current_platform() -> str:
    """Return this machine's platform, such as "linux-x64".

    Raises
    ------
    DevError
        If the extension is not built for it.
    """
    system, machine = sys.platform, platform.machine().lower()
    name = f"{_SYSTEMS.get(system, system)}-{_MACHINES.get(machine, machine)}"
    if name not in PLATFORMS:
        raise DevError(f"the extension is not built for {name}, only for {', '.join(PLATFORMS)}")
    return name
