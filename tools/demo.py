# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The demo: the built zip, installed into the bpy module, segments the sample model headless."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

from . import build, environments
from .blenders import DEFAULT_BLENDER
from .console import say, step
from .errors import DevError
from .places import OUT, ROOT
from .platforms import current_platform
from .processes import python_environment

MODEL = ROOT / "assets" / "models" / "pavilion.obj"

# `blender --command curvature …` without a Blender program: the function that the installed
# extension registers for it is called in the bpy module.
_SESSION = """
import os, sys
import bpy
zip_file, *arguments = sys.argv[1:]
commands = {}
register = bpy.utils.register_cli_command

def remember(name, run):
    commands[name] = run
    return register(name, run)

bpy.utils.register_cli_command = remember
bpy.ops.extensions.package_install_files(
    filepath=zip_file, repo="user_default", enable_on_install=True
)
status = commands["curvature"](arguments)
sys.stdout.flush()
os._exit(status)
"""


def run() -> int:
    """Build, install, segment; leave demo.blend, demo.json and demo.png in out/.

    Raises
    ------
    DevError
        If the sample model is missing or the extension does not leave the three files.
    """
    if not MODEL.is_file():
        raise DevError(f"the sample model {MODEL.relative_to(ROOT)} is missing")
    python = environments.ensure(DEFAULT_BLENDER.environment)
    zip_file = build.build(DEFAULT_BLENDER.series, [current_platform()])[0]
    OUT.mkdir(exist_ok=True)
    results = [OUT / f"demo.{ending}" for ending in ("blend", "json", "png")]
    for path in results:
        path.unlink(missing_ok=True)
    with step(f"segmenting {MODEL.name}"), tempfile.TemporaryDirectory() as user:
        status = _segment(python, zip_file, results, Path(user))
    missing = [path.name for path in results if not path.is_file()]
    if status:
        raise DevError(f"the extension's command ended with status {status}, see above")
    if missing:
        raise DevError(f"the extension's command left no {', '.join(missing)} in {OUT}")
    _print_classes(results[1])
    for path in results:
        say(f"made {path.relative_to(ROOT)}")
    return 0


def _segment(python: Path, zip_file: Path, results: list[Path], user: Path) -> int:
    blend, report, image = results
    arguments = ["segment", MODEL, "--output", blend, "--report", report, "--image", image]
    return run_command(python, zip_file, [*arguments, "--overwrite"], user)


def run_command(python: Path, zip_file: Path, arguments: Sequence[str | Path], user: Path) -> int:
    """Run the extension's command in the bpy module, and return its exit status.

    Parameters
    ----------
    python : Path
        Of an environment with bpy.
    zip_file : Path
    arguments : sequence of str or Path
        What follows `blender --command curvature`.
    user : Path
        Empty folder for Blender's user files.
    """
    return subprocess.run(
        [python, "-c", _SESSION, zip_file, *arguments],
        env=python_environment(BLENDER_USER_RESOURCES=os.fspath(user)),
        check=False,
    ).returncode


def _print_classes(report: Path) -> None:
    """Print the report's table of classes."""
    for model in json.loads(report.read_text(encoding="utf-8"))["objects"]:
        print(f"{model['name']}: {model['faces']} faces, {model['area']:.1f} m²")
        print(
            f"  {'class':<26}{'area':>12}{'share':>9}{'faces':>8}{'regions':>9}{'radius from':>13}"
        )
        for name, of_class in model["classes"].items():
            smallest = of_class["min_radius"]
            radius = "–" if smallest is None else f"{smallest:.2f} m"
            size = f"{of_class['area']:>9.1f} m²{of_class['share']:>9.1%}"
            counts = f"{of_class['faces']:>8}{of_class['regions']:>9}"
            print(f"  {name.replace('_', ' '):<26}{size}{counts}{radius:>13}")
