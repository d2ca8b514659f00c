# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Repacking leaves libigl's core only, always gives the same bytes and a wheel that is sound."""

import base64
import csv
import hashlib
import zipfile
from pathlib import Path

import pytest

from tools import repack

_CONTENT = {
    "igl/__init__.py": "from .pyigl_core import *\n",
    "igl/pyigl_core.cpython-311-x86_64-linux-gnu.so": "core",
    "igl/pyigl_core.pyi": "types",
    "igl/triangle/__init__.py": "",
    "igl/triangle/pyigl_restricted_triangle.cpython-311-x86_64-linux-gnu.so": "not free",
    "igl/copyleft/tetgen/pyigl_copyleft_tetgen.cpython-311-x86_64-linux-gnu.so": "copyleft",
    "include/Eigen/Core": "header",
    "lib64/libembree4.a": "library",
    "share/doc/libigl/readme.pdf": "manual",
    "libigl-2.6.3.dist-info/METADATA": "Metadata-Version: 2.1\nName: libigl\nVersion: 2.6.3\n\n",
    "libigl-2.6.3.dist-info/WHEEL": "Wheel-Version: 1.0\nRoot-Is-Purelib: false\n",
    "libigl-2.6.3.dist-info/RECORD": "",
    "libigl-2.6.3.dist-info/licenses/LICENSE.MPL2": "licence",
}
_INFO = "libigl-2.6.3+core.1.dist-info"


@pytest.fixture
def original(tmp_path: Path) -> Path:
    path = tmp_path / "libigl-2.6.3-cp311-cp311-manylinux_2_27_x86_64.manylinux_2_28_x86_64.whl"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as packed:
        for name, text in _CONTENT.items():
            packed.writestr(name, text)
    return path


def test_only_the_core_and_its_licences_are_left(original: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(repack.repack(original, tmp_path / "new")) as packed:
        assert packed.namelist() == sorted(
            [
                "igl/__init__.py",
                "igl/pyigl_core.cpython-311-x86_64-linux-gnu.so",
                *(f"{_INFO}/{name}" for name in ("METADATA", "RECORD", "WHEEL")),
                f"{_INFO}/licenses/LICENSE.MPL2",
            ]
        )


def test_name_and_metadata_say_that_it_is_not_the_original(original: Path, tmp_path: Path) -> None:
    repacked = repack.repack(original, tmp_path / "new")
    assert repacked.name == original.name.replace("2.6.3", "2.6.3+core.1")
    with zipfile.ZipFile(repacked) as packed:
        assert b"\nVersion: 2.6.3+core.1\n" in packed.read(f"{_INFO}/METADATA")


def test_record_lists_every_file_with_its_hash(original: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(repack.repack(original, tmp_path / "new")) as packed:
        rows = list(csv.reader(packed.read(f"{_INFO}/RECORD").decode().splitlines()))
        assert sorted(row[0] for row in rows) == packed.namelist()
        for path, digest, size in rows:
            if path.endswith("/RECORD"):
                continue
            content = packed.read(path)
            raw = hashlib.sha256(content).digest()
            assert digest == "sha256=" + base64.urlsafe_b64encode(raw).decode().rstrip("=")
            assert int(size) == len(content)


def test_bytes_depend_on_the_content_only(original: Path, tmp_path: Path) -> None:
    first = repack.repack(original, tmp_path / "first").read_bytes()
    shuffled = tmp_path / "again" / original.name
    shuffled.parent.mkdir()
    with zipfile.ZipFile(shuffled, "w", zipfile.ZIP_STORED) as packed:
        for name, text in reversed(_CONTENT.items()):
            packed.writestr(zipfile.ZipInfo(name, (2026, 5, 4, 3, 2, 2)), text)
    assert repack.repack(shuffled, tmp_path / "second").read_bytes() == first
