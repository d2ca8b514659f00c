# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures for docs/: lines, hatching and the report, made by the built extension, headless."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

from . import build, environments
from .blenders import DEFAULT_BLENDER
from .console import step
from .demo import MODEL, run_command
from .errors import DevError
from .places import ROOT
from .platforms import current_platform
from .processes import python_environment

FOLDER = ROOT / "docs" / "pictures"
KINDS = ("lines", "hatching", "report")
_MODELS = (ROOT / "assets" / "models" / "ellipsoid.obj", MODEL)
_WIDTH, _HEIGHT = "1200", "750"
_PAGE = "1100,1375"
_CHROMIUM = ("chromium", "chromium-browser", "google-chrome")

# Hatching has a button and an operator, and no subcommand.
_HATCHING = """
import importlib, os, sys
from pathlib import Path
import bpy
zip_file, model, axis, image, width, height = sys.argv[1:]
bpy.ops.extensions.package_install_files(
    filepath=zip_file, repo="user_default", enable_on_install=True
)
for obj in list(bpy.data.objects):
    bpy.data.objects.remove(obj)
forward = {"Y": "NEGATIVE_Z", "Z": "Y"}
axes = {"up_axis": axis, "forward_axis": forward[axis]} if axis else {}
bpy.ops.wm.obj_import(filepath=model, **axes)
made = bpy.context.selected_objects
bpy.context.view_layer.objects.active = made[0]
bpy.ops.curvature.hatch()
package = "bl_ext.user_default.architectural_curvature.addon.bridge"
picture = importlib.import_module(f"{package}.picture")
picture.render(made, None, (int(width), int(height)), Path(image), is_plain=True)
sys.stdout.flush()
os._exit(0)
"""


def write(
    kind: str, models: Sequence[Path], spacing: float | None = None, up: str | None = None
) -> list[Path]:
    """Make pictures of models: `docs/pictures/<kind>-<model>.png`, or `report.png` of the first.

    Parameters
    ----------
    kind : str
        One of `KINDS`: both families of curvature lines, strokes along them, or the HTML report as
        a browser shows it.
    models : sequence of Path
        Sample models where there are none.
    spacing : float, optional
        Between lines, in meters; by default that of the command.
    up : str, optional
        Y or Z: the axis that points up; by default Blender's for the format.

    Returns
    -------
    list of Path

    Raises
    ------
    DevError
        If the extension leaves no picture, or there is no browser to show the report.
    """
    python = environments.ensure(DEFAULT_BLENDER.environment)
    zip_file = build.build(DEFAULT_BLENDER.series, [current_platform()])[0]
    if kind == "report":
        return [_report(python, zip_file, models[0] if models else MODEL, up)]
    made = []
    for model in models or _MODELS:
        path = FOLDER / f"{kind}-{model.stem.replace('_', '-')}.png"
        with step(f"drawing {model.name}"), tempfile.TemporaryDirectory() as user:
            if kind == "lines":
                arguments = ["lines", model, "--image", path, "--image-size", f"{_WIDTH}x{_HEIGHT}"]
                arguments += ["--spacing", str(spacing)] if spacing else []
                arguments += ["--up", up] if up else []
                status = run_command(python, zip_file, [*arguments, "--overwrite"], Path(user))
            else:
                status = subprocess.run(
                    [python, "-c", _HATCHING, zip_file, model, up or "", path, _WIDTH, _HEIGHT],
                    env=python_environment(BLENDER_USER_RESOURCES=user),
                    check=False,
                ).returncode
        if status or not path.is_file():
            raise DevError(f"Blender ended with status {status} and made no picture, see above")
        made.append(path)
    return made


def _report(python: Path, zip_file: Path, model: Path, up: str | None) -> Path:
    browser = next(filter(None, map(shutil.which, _CHROMIUM)), None)
    if browser is None:
        raise DevError("no Chromium to show the report in: on Debian, apt-get install chromium")
    path = FOLDER / "report.png"
    with step(f"reporting {model.name}"), tempfile.TemporaryDirectory() as name:
        page = Path(name, "report.html")
        # The report tells the path as it was given.
        arguments = ["segment", os.path.relpath(model), "--report", page]
        arguments += ["--up", up] if up else []
        status = run_command(python, zip_file, arguments, Path(name, "user"))
        if status:
            raise DevError(f"the extension's command ended with status {status}, see above")
        subprocess.run(
            [
                browser, "--headless", "--no-sandbox", "--hide-scrollbars",
                f"--screenshot={os.fspath(path)}", f"--window-size={_PAGE}", page.as_uri(),
            ],
            check=True,
            capture_output=True,
        )  # fmt: skip
    return path
