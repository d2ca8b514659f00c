# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures for docs/: the built extension traces curvature lines on models, headless."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path

from . import build, environments
from .blenders import DEFAULT_BLENDER
from .console import step
from .demo import run_command
from .errors import DevError
from .places import ROOT
from .platforms import current_platform

FOLDER = ROOT / "docs" / "pictures"
_MODELS = (ROOT / "assets" / "models" / "ellipsoid.obj",)
_SIZE = "1200x750"


def write(
    models: Sequence[Path], spacing: float | None = None, up: str | None = None
) -> list[Path]:
    """Render both families of lines on models into `docs/pictures/lines-<model>.png`.

    Parameters
    ----------
    models : sequence of Path
        The sample ellipsoid where there are none.
    spacing : float, optional
        In meters; by default that of the command.

    up : str, optional
        Y or Z: the axis that points up; by default Blender's for the format.

    Returns
    -------
    list of Path

    Raises
    ------
    DevError
        If the extension leaves no picture.
    """
    python = environments.ensure(DEFAULT_BLENDER.environment)
    zip_file = build.build(DEFAULT_BLENDER.series, [current_platform()])[0]
    made = []
    for model in models or _MODELS:
        path = FOLDER / f"lines-{model.stem.replace('_', '-')}.png"
        arguments = ["lines", model, "--image", path, "--image-size", _SIZE]
        if spacing:
            arguments += ["--spacing", str(spacing)]
        if up:
            arguments += ["--up", up]
        with step(f"tracing {model.name}"), tempfile.TemporaryDirectory() as user:
            status = run_command(python, zip_file, [*arguments, "--overwrite"], Path(user))
        if status:
            raise DevError(f"the extension's command ended with status {status}, see above")
        made.append(path)
    return made
