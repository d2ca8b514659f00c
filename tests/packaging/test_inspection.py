# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The inspection after a build finds what Blender's own validation does not notice."""

import zipfile
from pathlib import Path

import pytest

from tools import inspection
from tools.errors import DevError

_IGL_311 = "wheels/libigl-2.6.3-cp311-cp311-manylinux_2_28_x86_64.whl"
_IGL_ABI3 = "wheels/libigl-2.6.3-cp312-abi3-manylinux_2_28_x86_64.whl"
_SCIPY_313 = "wheels/scipy-1.15.3-cp313-cp313-manylinux2014_x86_64.whl"


def _zip(folder: Path, named: list[str], carried: list[str]) -> Path:
    listed = ", ".join(f'"./{wheel}"' for wheel in named)
    path = folder / "extension.zip"
    with zipfile.ZipFile(path, "w") as packed:
        packed.writestr(
            "blender_manifest.toml",
            f"wheels = [{listed}]\n[build.generated]\nwheels = [{listed}]\n",
        )
        packed.writestr("__init__.py", "")
        for name in carried:
            packed.writestr(name, "")
    return path


def test_sound_zip_passes(tmp_path: Path) -> None:
    wheels = [_IGL_ABI3, _SCIPY_313]
    inspection.inspect_zip(_zip(tmp_path, wheels, wheels))


def test_missing_wheel_is_found(tmp_path: Path) -> None:
    path = _zip(tmp_path, [_IGL_ABI3, _SCIPY_313], [_IGL_ABI3])
    with pytest.raises(DevError, match=r"scipy\S+ is in its manifest but not in it"):
        inspection.inspect_zip(path)


def test_unnamed_wheel_is_found(tmp_path: Path) -> None:
    path = _zip(tmp_path, [_IGL_ABI3], [_IGL_ABI3, _SCIPY_313])
    with pytest.raises(DevError, match=r"scipy\S+ is in it but not in its manifest"):
        inspection.inspect_zip(path)


@pytest.mark.parametrize("name", ["tests/test_one.py", "tools/build.py", "pyproject.toml"])
def test_developers_file_is_found(tmp_path: Path, name: str) -> None:
    path = _zip(tmp_path, [_IGL_ABI3], [_IGL_ABI3, name])
    with pytest.raises(DevError, match="does not belong in it"):
        inspection.inspect_zip(path)


@pytest.mark.parametrize("wheels", [(_IGL_311, _IGL_ABI3), (_IGL_311, _SCIPY_313)])
def test_wheels_for_several_pythons_are_found(wheels: tuple[str, ...]) -> None:
    assert list(inspection.find_mixed_pythons(wheels))
