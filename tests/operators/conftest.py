# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of operators share."""

from __future__ import annotations

import re
from collections.abc import Callable

import bpy
import pytest

Report = Callable[..., tuple[set[str], str]]


@pytest.fixture
def run(capfd: pytest.CaptureFixture[str]) -> Report:
    """Run an operator and return its result and what it reported, such as "Info: Done"."""

    def call(name: str, *arguments: str, **properties: object) -> tuple[set[str], str]:
        capfd.readouterr()
        try:
            result = getattr(bpy.ops.curvature, name)(*arguments, **properties)
        except RuntimeError as error:
            # A report of an error becomes an exception in Python.
            capfd.readouterr()
            return {"CANCELLED"}, _first_line(str(error))
        output = capfd.readouterr()
        assert "Traceback" not in output.out + output.err
        return result, _first_line(output.out)

    return call


def _first_line(text: str) -> str:
    """Return the report without the place in Blender that Blender 4.2 adds."""
    lines = [line for line in text.splitlines() if re.match(r"(Info|Warning|Error): ", line)]
    return lines[0] if lines else ""
