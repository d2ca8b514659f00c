# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Classes that Blender registers are named and described as Blender's own are."""

from __future__ import annotations

import ast
from collections.abc import Iterator

import pytest

_SMALL = {"a", "an", "and", "as", "at", "by", "for", "from", "in", "of", "on", "or", "the", "to"}
_PROPERTIES = {
    "BoolProperty",
    "BoolVectorProperty",
    "CollectionProperty",
    "EnumProperty",
    "FloatProperty",
    "FloatVectorProperty",
    "IntProperty",
    "IntVectorProperty",
    "PointerProperty",
    "StringProperty",
}
_BRITISH = ("colour", "metre", "grey", "centre", "neighbour", "analyse", "behaviour", "organis")


def _classes(shipped: list, kind: str) -> list[tuple[str, ast.ClassDef]]:
    found = [
        (str(source), node)
        for source in shipped
        for node in source.places(ast.ClassDef)
        if any(getattr(base, "id", "") == kind for base in node.bases)
    ]
    assert found
    return found


def _constants(node: ast.ClassDef) -> dict[str, object]:
    """Return the constants that are assigned in a class, and what is not constant as its text."""
    found: dict[str, object] = {}
    for statement in node.body:
        if isinstance(statement, ast.Assign) and isinstance(statement.targets[0], ast.Name):
            try:
                value = ast.literal_eval(statement.value)
            except ValueError:
                value = ast.unparse(statement.value)
            found[statement.targets[0].id] = value
    return found


def _methods(node: ast.ClassDef) -> dict[str, ast.FunctionDef]:
    return {part.name: part for part in node.body if isinstance(part, ast.FunctionDef)}


def _texts(shipped: list) -> Iterator[tuple[str, str]]:
    """Give every text that users may read: constants but docstrings and single words."""
    for source in shipped:
        documentation = {
            id(node.body[0].value)
            for node in source.places(ast.Module, ast.ClassDef, ast.FunctionDef)
            if node.body and isinstance(node.body[0], ast.Expr)
        }
        for node in source.places(ast.Constant):
            if isinstance(node.value, str) and id(node) not in documentation:
                yield f"{source}:{node.lineno}", node.value


def test_operators_are_named_after_what_they_do(shipped: list) -> None:
    for path, node in _classes(shipped, "Operator"):
        verb = node.name.removeprefix("CURVATURE_OT_")
        assert node.name == f"CURVATURE_OT_{verb}"
        assert _constants(node)["bl_idname"] == f"curvature.{verb}"
        assert path == f"operators/{verb}.py", "one operator per file, of the same name"


def test_panels_are_named_after_what_they_show(shipped: list) -> None:
    for path, node in _classes(shipped, "Panel"):
        noun = node.name.removeprefix("CURVATURE_PT_")
        assert node.name == f"CURVATURE_PT_{noun}"
        assert _constants(node)["bl_idname"] == node.name
        assert path == f"addon/panels/{noun}.py", "one panel per file, of the same name"


def test_property_groups_are_named_as_such(shipped: list) -> None:
    for _path, node in _classes(shipped, "PropertyGroup"):
        assert node.name.startswith("CURVATURE_PG_")


def test_operators_describe_themselves_and_can_be_undone_or_say_why_not(shipped: list) -> None:
    by_path = {str(source): source for source in shipped}
    for path, node in _classes(shipped, "Operator"):
        constants = _constants(node)
        assert {"bl_label", "bl_description", "bl_options"} <= constants.keys(), node.name
        if constants["bl_options"] != {"REGISTER", "UNDO"}:
            line = next(
                part.lineno
                for part in node.body
                if isinstance(part, ast.Assign) and part.targets[0].id == "bl_options"
            )
            assert by_path[path].text.splitlines()[line - 2].strip().startswith("# "), node.name


def test_operators_say_why_they_cannot_run(shipped: list) -> None:
    """Poll is a class method that sets a message, or asks a function of polls.py that does."""
    asked = {
        node.name
        for source in shipped
        if str(source) == "addon/polls.py"
        for node in source.places(ast.FunctionDef)
        if "poll_message_set" in ast.unparse(node)
    }
    for _path, node in _classes(shipped, "Operator"):
        poll = _methods(node).get("poll")
        assert poll is not None, node.name
        assert [ast.unparse(each) for each in poll.decorator_list] == ["classmethod"]
        text = ast.unparse(poll)
        assert "poll_message_set" in text or any(f"polls.{name}(" in text for name in asked)


def test_draw_and_poll_are_short_and_try_nothing(shipped: list) -> None:
    for kind in ("Panel", "Operator"):
        for _path, node in _classes(shipped, kind):
            for name, method in _methods(node).items():
                if name in {"draw", "poll"}:
                    assert len(ast.unparse(method).splitlines()) <= 30, f"{node.name}.{name}"
                    assert not [n for n in ast.walk(method) if isinstance(n, ast.Try)]


def test_labels_are_in_title_case(shipped: list) -> None:
    for kind in ("Operator", "Panel"):
        for _path, node in _classes(shipped, kind):
            words = str(_constants(node)["bl_label"]).split()
            assert words[0][0].isupper(), node.name
            assert all(word[0].isupper() or word in _SMALL for word in words), node.name


def test_descriptions_are_one_sentence_without_a_full_stop(shipped: list) -> None:
    for _path, node in _classes(shipped, "Operator"):
        text = str(_constants(node)["bl_description"])
        assert text[0].isupper(), node.name
        assert not text.endswith((".", "!")), node.name
        assert ". " not in text, node.name
        assert "\n" not in text, node.name
        assert 10 <= len(text) <= 160, node.name


def test_every_property_has_a_name_and_a_description(shipped: list) -> None:
    wrong = []
    for source in shipped:
        for node in source.places(ast.Call):
            if getattr(node.func, "id", "") not in _PROPERTIES:
                continue
            given = {keyword.arg for keyword in node.keywords}
            is_pointer_to_our_group = "type" in given and "CURVATURE_PG_" in ast.unparse(node)
            is_attached = is_pointer_to_our_group and node.func.id == "PointerProperty"
            if not is_attached and not {"name", "description"} <= given:
                wrong.append(f"{source}:{node.lineno}")
    assert not wrong


def test_failure_is_cancelled_not_finished(shipped: list) -> None:
    """After a report of an error an operator must not push an undo step."""
    for _path, node in _classes(shipped, "Operator"):
        for block in ast.walk(node):
            statements = getattr(block, "body", None)
            if not isinstance(statements, list):
                continue
            for number, statement in enumerate(statements[:-1]):
                if "'ERROR'" in ast.unparse(statement) and isinstance(statement, ast.Expr):
                    assert ast.unparse(statements[number + 1]) == "return {'CANCELLED'}"


@pytest.mark.parametrize("word", _BRITISH)
def test_texts_are_in_american_english(word: str, shipped: list) -> None:
    assert not [f"{place}: {text}" for place, text in _texts(shipped) if word in text.lower()]
