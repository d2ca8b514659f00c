# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Repacking the libigl wheel with its core only; docs/packaging.md says why.

The same original always gives the same bytes: files are sorted, carry one fixed date and are
stored without compression, because the output of zlib differs between its versions.
"""

from __future__ import annotations

import base64
import hashlib
import re
import zipfile
from pathlib import Path

# A local version, so that neither people nor installers take the file for the original. Blender
# tells unpacked wheels apart by version only: count up whenever the content changes, or users keep
# the old one.
LOCAL_VERSION = "core.1"

_KEPT = re.compile(r"igl/(__init__\.py|pyigl_core\.[^/]*(so|pyd))|[^/]+\.dist-info/.+")
_DATE = (1980, 1, 1, 0, 0, 0)


def is_repacked(requirement: str) -> bool:
    """Tell whether a package is shipped repacked."""
    return requirement.startswith("libigl==")


def repack(original: Path, folder: Path) -> Path:
    """Write the core of a libigl wheel to a new wheel in `folder` and return it."""
    folder.mkdir(parents=True, exist_ok=True)
    name, version, *tags = original.stem.split("-")
    new_version = f"{version}+{LOCAL_VERSION}"
    old_info, new_info = f"{name}-{version}.dist-info", f"{name}-{new_version}.dist-info"
    with zipfile.ZipFile(original) as packed:
        content = {
            path.replace(old_info, new_info): packed.read(path)
            for path in packed.namelist()
            if _KEPT.fullmatch(path)
        }
    metadata = content[f"{new_info}/METADATA"]
    content[f"{new_info}/METADATA"] = metadata.replace(
        f"\nVersion: {version}\n".encode(), f"\nVersion: {new_version}\n".encode(), 1
    )
    content[f"{new_info}/RECORD"] = _record(content, f"{new_info}/RECORD")
    repacked = folder / "-".join((name, new_version, *tags))
    repacked = repacked.with_name(f"{repacked.name}.whl")
    with zipfile.ZipFile(repacked, "w", zipfile.ZIP_STORED) as target:
        for path in sorted(content):
            entry = zipfile.ZipInfo(path, _DATE)
            entry.create_system = 3  # Unix, wherever it runs: part of the bytes
            entry.external_attr = 0o644 << 16
            target.writestr(entry, content[path])
    return repacked


def _record(content: dict[str, bytes], record: str) -> bytes:
    """Return the wheel's list of files with their hashes and sizes."""
    lines = []
    for path in sorted(content.keys() - {record}):
        digest = base64.urlsafe_b64encode(hashlib.sha256(content[path]).digest()).rstrip(b"=")
        lines.append(f"{path},sha256={digest.decode()},{len(content[path])}\n")
    return "".join([*lines, f"{record},,\n"]).encode()
