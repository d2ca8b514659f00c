# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sources follow the rules that no linter knows, or that must hold whatever its settings."""

from __future__ import annotations

import ast
import re
from pathlib import Path

_LONGEST_FILE = 300
_VAGUE = {"utils", "util", "helpers", "helper", "common", "misc", "stuff", "tools"}
_FORBIDDEN_NAMES = {"__file__", "bl_info"}


def test_there_are_sources_to_check(shipped: list, sources: list) -> None:
    assert len(shipped) > 50
    assert len(sources) > len(shipped)


def test_files_are_short(sources: list) -> None:
    too_long = {str(s): s.text.count("\n") for s in sources if s.text.count("\n") > _LONGEST_FILE}
    assert not too_long


def test_file_names_say_what_is_inside(sources: list) -> None:
    names = [part for source in sources for part in source.path.with_suffix("").parts[1:]]
    assert not {n for n in names if n in _VAGUE or n.rsplit("_", 1)[-1] in _VAGUE}


def test_every_file_has_its_licence_and_a_sentence_about_itself(sources: list) -> None:
    wrong = [
        str(source)
        for source in sources
        if "SPDX-License-Identifier: GPL-3.0-or-later"
        not in "\n".join(source.text.splitlines()[:4])
        or not ast.get_docstring(source.tree)
    ]
    assert not wrong


def test_nothing_is_printed(shipped: list) -> None:
    wrong = [
        f"{source}:{node.lineno}"
        for source in shipped
        for node in source.places(ast.Name)
        if node.id in {"print", "pprint"}
    ]
    assert not wrong


def test_exceptions_are_caught_by_name(shipped: list) -> None:
    wrong = []
    for source in shipped:
        for node in source.places(ast.ExceptHandler):
            caught = (
                {n.id for n in ast.walk(node.type) if isinstance(n, ast.Name)}
                if node.type
                else set()
            )
            if not caught or caught & {"Exception", "BaseException"}:
                wrong.append(f"{source}:{node.lineno}")
    assert not wrong


def test_caught_exceptions_are_not_swallowed(shipped: list) -> None:
    wrong = [
        f"{source}:{node.lineno}"
        for source in shipped
        for node in source.places(ast.ExceptHandler)
        if all(isinstance(statement, ast.Pass) for statement in node.body)
    ]
    assert not wrong


def test_package_does_not_look_for_itself(shipped: list) -> None:
    """Extensions can be anywhere, and must not change where Python looks for modules."""
    wrong = []
    for source in shipped:
        wrong += [
            f"{source}:{node.lineno}"
            for node in source.places(ast.Name)
            if node.id in _FORBIDDEN_NAMES
        ]
        wrong += [
            f"{source}:{node.lineno}"
            for node in source.places(ast.Attribute)
            if node.attr == "path" and getattr(node.value, "id", "") == "sys"
        ]
    assert not wrong


def test_nothing_is_left_to_do(sources: list) -> None:
    marks = re.compile(
        r"#.*\b(" + "|".join(("TO" + "DO", "FIX" + "ME", "X" + "XX", "HA" + "CK")) + r")\b"
    )
    wrong = [
        f"{source}:{number}"
        for source in sources
        for number, line in enumerate(source.text.splitlines(), 1)
        if marks.search(line)
    ]
    assert not wrong


def test_tool_settings_are_those_of_a_scene(sources: list) -> None:
    """Asking the context for them leaves it with a pointer to the scene of a closed file."""
    wrong = [
        f"{source}:{node.lineno}"
        for source in sources
        for node in source.places(ast.Attribute)
        if node.attr == "tool_settings" and ast.unparse(node.value).endswith("context")
    ]
    assert not wrong


def test_no_star_imports(sources: list) -> None:
    wrong = [
        f"{source}:{node.lineno}"
        for source in sources
        for node in source.places(ast.ImportFrom)
        if any(alias.name == "*" for alias in node.names)
    ]
    assert not wrong


def test_no_operator_is_called_but_where_blender_has_no_other_way(shipped: list) -> None:
    """Operators depend on mode, selection and window; they are kept in the bridge."""
    wrong = [
        f"{source}:{node.lineno}"
        for source in shipped
        if not str(source).startswith("addon/bridge/")
        for node in source.places(ast.Attribute)
        if node.attr == "ops" and getattr(node.value, "id", "") == "bpy"
    ]
    assert not wrong


def test_every_test_folder_is_known_to_git(repository: Path) -> None:
    """An empty folder of tests would pass in silence."""
    folders = [path for path in (repository / "tests").iterdir() if path.is_dir()]
    empty = [
        path.name
        for path in folders
        if path.name not in {"__pycache__", "surfaces", "composites"}
        and not any(path.rglob("test_*.py"))
    ]
    assert not empty
