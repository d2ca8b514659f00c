# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What Blender's `extension validate` does not notice about a zip: looked at after every build."""

from __future__ import annotations

import tomllib
import zipfile
from collections.abc import Iterable
from pathlib import Path

from .errors import DevError
from .manifest import FILE_NAME

# A guard, not the list of what ships: that is in the manifest's exclude patterns.
_TOP_LEVEL = {
    *("__init__.py", FILE_NAME, "addon", "operators", "assets", "wheels"),
    *("LICENSE", "README.md", "CHANGELOG.md"),
}


def inspect_zip(path: Path) -> None:
    """Raise `DevError` if a built zip lacks a wheel, carries strange files or mixes Pythons."""
    problems = list(find_problems(path))
    if problems:
        raise DevError(f"{path.name} must not be released: {'; '.join(problems)}")


def find_problems(path: Path) -> Iterable[str]:
    """Yield what is wrong with a zip, one sentence part each."""
    with zipfile.ZipFile(path) as packed:
        names = packed.namelist()
        manifest = tomllib.loads(packed.read(FILE_NAME).decode())
    named = {wheel.removeprefix("./") for wheel in manifest["build"]["generated"]["wheels"]}
    carried = {name for name in names if name.endswith(".whl")}
    yield from (f"{wheel} is in its manifest but not in it" for wheel in sorted(named - carried))
    yield from (f"{wheel} is in it but not in its manifest" for wheel in sorted(carried - named))
    if not carried:
        yield "it carries no wheels"
    strange = {name.split("/")[0] for name in names} - _TOP_LEVEL
    yield from (f"{name} does not belong in it" for name in sorted(strange))
    yield from find_mixed_pythons(manifest["wheels"])


def find_mixed_pythons(wheel_names: Iterable[str]) -> Iterable[str]:
    """Yield a sentence if Blender would refuse every Python for this set of wheels.

    Blender joins the Python versions of all wheels; an exact one (cp311) then hides that others
    are for any newer Python (cp312-abi3). One exact version is all right, two are not, and an abi3
    wheel must not be for a newer Python than the exact one.
    """
    exact: set[int] = set()
    stable: set[int] = set()
    for name in wheel_names:
        python_tag, abi_tag = Path(name).stem.split("-")[-3:-1]
        minor = int(python_tag.removeprefix("cp3"))
        (stable if abi_tag == "abi3" else exact).add(minor)
    if len(exact) > 1:
        yield f"its wheels are for several Pythons (3.{', 3.'.join(map(str, sorted(exact)))})"
    elif exact and stable and max(stable) > min(exact):
        yield f"a wheel needs Python 3.{max(stable)}, another is for Python 3.{min(exact)} only"
