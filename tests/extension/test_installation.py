# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The installed zip is enabled, brings its own libraries and keeps the other series out."""

import importlib
import importlib.metadata
import os
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import bpy
import numpy as np
import pytest


@pytest.fixture(scope="module")
def wheel_folder() -> Path:
    """Where Blender unpacks the wheels of all extensions."""
    return Path(bpy.utils.user_resource("EXTENSIONS"), ".local").resolve()


@pytest.fixture(scope="module")
def zip_file() -> Path:
    return Path(os.environ["ARCHITECTURAL_CURVATURE_ZIP"])


@pytest.fixture(scope="module")
def other_zip_file() -> Path:
    return Path(os.environ["ARCHITECTURAL_CURVATURE_OTHER_ZIP"])


def _zip_manifest(path: Path) -> dict:
    with zipfile.ZipFile(path) as packed:
        return tomllib.loads(packed.read("blender_manifest.toml").decode())


def test_extension_is_enabled_and_is_the_zip(extension: str, zip_file: Path) -> None:
    assert extension in bpy.context.preferences.addons
    installed = Path(importlib.import_module(extension).__file__).parent
    manifest = tomllib.loads((installed / "blender_manifest.toml").read_text(encoding="utf-8"))
    assert manifest == _zip_manifest(zip_file)


@pytest.mark.parametrize(
    "module",
    [
        "igl",
        "scipy",
        "scipy.linalg",
        "scipy.ndimage",
        "scipy.optimize",
        "scipy.sparse",
        "scipy.sparse.csgraph",
        "scipy.sparse.linalg",
        "scipy.spatial",
    ],
)
def test_library_comes_from_the_wheels(module: str, wheel_folder: Path) -> None:
    assert Path(importlib.import_module(module).__file__).resolve().is_relative_to(wheel_folder)


def test_numpy_is_that_of_blender(wheel_folder: Path) -> None:
    assert not Path(np.__file__).resolve().is_relative_to(wheel_folder)


def test_libigl_is_the_core_only() -> None:
    assert importlib.metadata.version("libigl").endswith("+core.1")
    for part in ("triangle", "copyleft", "embree"):
        with pytest.raises(ModuleNotFoundError):
            importlib.import_module(f"igl.{part}")


def test_libigl_computes() -> None:
    import igl

    x, y = np.meshgrid(np.linspace(-1.0, 1.0, 21), np.linspace(-1.0, 1.0, 21))
    vertices = np.column_stack([x.ravel(), y.ravel(), np.sqrt(100.0 - x.ravel() ** 2)])
    corner = np.arange(20 * 21).reshape(20, 21)[:, :-1].ravel()
    faces = np.vstack(
        [
            np.column_stack([corner, corner + 1, corner + 22]),
            np.column_stack([corner, corner + 22, corner + 21]),
        ]
    )
    values = [np.asarray(value) for value in igl.principal_curvature(vertices, faces)[:4]]
    middle = len(vertices) // 2
    # A cylinder of radius 10: |k| = 0.1 across and 0 along.
    assert np.sort(np.abs([values[2][middle], values[3][middle]])) == pytest.approx(
        [0.0, 0.1], abs=1e-3
    )


# In a process of its own: trying to install over it, Blender loads the extension's modules anew,
# and tests that run later would hold the old ones.
_INSTALL_BOTH = """
import sys
import bpy
for zip_file in sys.argv[1:]:
    bpy.ops.extensions.package_install_files(
        filepath=zip_file, repo="user_default", enable_on_install=True
    )
print("ENABLED", *bpy.context.preferences.addons.keys())
"""


def test_zip_of_the_other_series_is_refused_in_words(
    extension: str, other_zip_file: Path, zip_file: Path, tmp_path: Path
) -> None:
    """Blender says which version it wants, and what was installed stays."""
    session = subprocess.run(  # noqa: S603 - a program of ours
        [sys.executable, "-c", _INSTALL_BOTH, zip_file, other_zip_file],
        env={**os.environ, "BLENDER_USER_RESOURCES": str(tmp_path)},
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=True,
    )
    output = session.stdout
    other = _zip_manifest(other_zip_file)
    if "blender_version_max" in other:
        expected = f"must be less than the maximum version ({other['blender_version_max']})"
    else:
        expected = f"doesn't meet the minimum supported version ({other['blender_version_min']})"
    assert expected in output
    assert "ERROR" in output
    assert extension in output.split("ENABLED")[1].split()
    installed = tmp_path / "extensions" / "user_default" / "architectural_curvature"
    manifest = tomllib.loads((installed / "blender_manifest.toml").read_text(encoding="utf-8"))
    assert manifest == _zip_manifest(zip_file)


def test_zip_has_its_wheels_and_no_files_of_developers(zip_file: Path) -> None:
    with zipfile.ZipFile(zip_file) as packed:
        names = packed.namelist()
    wheels = _zip_manifest(zip_file)["build"]["generated"]["wheels"]
    assert {name for name in names if name.endswith(".whl")} == {
        wheel.removeprefix("./") for wheel in wheels
    }
    top_level = {name.split("/")[0] for name in names}
    assert not top_level & {"tests", "tools", "docs", "dev.py", "pyproject.toml", ".ci", ".git"}
    assert not [name for name in names if "__pycache__" in name or name.endswith(".pyc")]


def test_blender_validates_the_zip(
    zip_file: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    """The validation of this very Blender, which may be newer than the one that built the zip."""
    scripts = Path(bpy.utils.system_resource("SCRIPTS"))
    tool = scripts / "addons_core" / "bl_pkg" / "cli"
    monkeypatch.syspath_prepend(str(tool))
    command_line = importlib.import_module("blender_ext")
    assert command_line.main(["validate", os.fspath(zip_file)]) in (0, None)
    assert "rror" not in "".join(capfd.readouterr())
