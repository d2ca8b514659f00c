# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the extension importable as `architectural_curvature`, whatever is being tested.

In plain Python that is the checkout, loaded as a package. In Blender's bpy module it is the zip
that `python3 dev.py test` names in ARCHITECTURAL_CURVATURE_ZIP, installed: never the checkout.
"""

import importlib.util
import os
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = "architectural_curvature"
ZIP_VARIABLE = "ARCHITECTURAL_CURVATURE_ZIP"
_PLAIN_LEVELS = ("policy", "packaging", "geometry", "report")
_STATUS: dict[pytest.Config, int] = {}


def pytest_configure() -> None:
    """Load or install the package before test modules are collected, as they import from it."""
    if PACKAGE in sys.modules:
        return
    if ZIP_VARIABLE in os.environ:
        from installed_zip import install_and_alias

        install_and_alias(Path(os.environ[ZIP_VARIABLE]), PACKAGE)
    else:
        _load_checkout()


def _load_checkout() -> None:
    spec = importlib.util.spec_from_file_location(
        PACKAGE, ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
    )
    assert spec is not None
    assert spec.loader is not None
    package = importlib.util.module_from_spec(spec)
    sys.modules[PACKAGE] = package
    spec.loader.exec_module(package)


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config: pytest.Config) -> None:
    """Leave at once after tests in Blender: module bpy 4.2 crashes while C++ tidies up after it.

    The report and the summary are written by then.
    """
    if ZIP_VARIABLE in os.environ and config in _STATUS:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(_STATUS[config])


def pytest_sessionfinish(session: pytest.Session, exitstatus: int) -> None:
    """Remember the status to leave with."""
    _STATUS[session.config] = int(exitstatus)


def pytest_collect_file(file_path: Path) -> None:
    """Refuse to test in Blender without a zip: passing on the checkout would prove nothing."""
    if not file_path.name.startswith("test_"):
        return
    level = file_path.relative_to(ROOT / "tests").parts[0]
    if level == "window":
        message = "tests/window runs in a windowed Blender: run `python3 dev.py window`"
        raise pytest.UsageError(message)
    if level not in _PLAIN_LEVELS and ZIP_VARIABLE not in os.environ:
        message = f"tests/{level} needs the built zip: run `python3 dev.py test`"
        raise pytest.UsageError(message)


@pytest.fixture(scope="session")
def repository() -> Path:
    """The root folder of the checkout."""
    return ROOT


@pytest.fixture(scope="session")
def extension() -> str:
    """The name of the installed extension's package, for `importlib.import_module`."""
    if ZIP_VARIABLE not in os.environ:
        pytest.fail("only a Blender that tests the built zip has an installed extension")
    from installed_zip import INSTALLED_PACKAGE

    return INSTALLED_PACKAGE


@pytest.fixture(autouse=True)
def _empty_scene() -> None:
    """Start every test in Blender with an empty factory scene and the extension enabled."""
    if ZIP_VARIABLE in os.environ:
        from installed_zip import reset_scene

        reset_scene()
