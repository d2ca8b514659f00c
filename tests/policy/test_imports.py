# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Dependencies point one way: operators, panels -> overlay, properties -> bridge -> geometry."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import PurePosixPath

import pytest

_BLENDER = {"bpy", "bmesh", "gpu", "blf", "mathutils", "bpy_extras", "gpu_extras", "addon_utils"}
_OUR_NAMES = {"addon", "operators", "architectural_curvature", "bl_ext"}

# What each part of the package may import of the package, besides itself.
_ALLOWED = {
    "": {"registration"},
    "geometry": set(),
    "report": {"geometry"},
    "export": {"geometry", "report"},
    "version": set(),
    "bridge": {"export", "geometry", "report", "preset_text"},
    "properties": {"bridge", "geometry"},
    "overlay": {"bridge", "geometry", "report"},
    "choices": {"bridge", "geometry", "preset_text", "tracing"},
    "polls": {"bridge"},
    "progress": {"geometry"},
    "handlers": {"bridge", "overlay"},
    "steps": {"geometry"},
    "tasks": {"bridge", "geometry", "steps"},
    "outlining": {"bridge", "geometry", "steps"},
    "editing": {"bridge", "geometry", "steps", "tasks"},
    "exporting": set(),
    "selecting": {"bridge"},
    "running": {"geometry", "progress", "reporting", "steps", "tasks"},
    "tracing": {"bridge", "geometry", "report", "steps", "tasks"},
    "reporting": {"bridge", "geometry", "report", "tasks", "version"},
    "presets": set(),
    "preset_text": set(),
    "panels": {"bridge", "geometry", "properties", "choices", "preset_text"},
    "operators": {
        "bridge", "geometry", "report", "properties", "overlay", "choices", "polls", "progress",
        "tasks", "reporting", "outlining", "editing", "preset_text", "running", "steps", "tracing",
        "export", "exporting", "selecting",
    },
    "cli": {
        "bridge", "geometry", "report", "properties", "overlay", "choices", "tasks", "reporting",
        "steps", "tracing", "export",
    },
    "registration": {
        "properties", "operators", "panels", "overlay", "handlers", "cli", "preferences", "presets",
    },
}  # fmt: skip


def _part(module: tuple[str, ...]) -> str:
    """Return the part of the package that a module belongs to: a folder or file of addon/."""
    names = module[1:] if module[:1] == ("addon",) else module
    return names[0] if names else ""


def _module(path: PurePosixPath) -> tuple[str, ...]:
    names = path.with_suffix("").parts
    return names[:-1] if names[-1] == "__init__" else names


def _imported(source: object) -> Iterator[tuple[str, ...]]:
    """Give the modules of the package that a file imports, from the root."""
    path = PurePosixPath(str(source))
    package = _module(path) if path.name == "__init__.py" else _module(path)[:-1]
    for node in source.places(ast.ImportFrom):
        if not node.level:
            continue
        base = package[: len(package) - node.level + 1]
        target = (*base, *(node.module.split(".") if node.module else ()))
        if target in {(), ("addon",)}:
            # `from . import geometry` names modules, not what is in one.
            yield from ((*target, alias.name) for alias in node.names)
        else:
            yield target


def _roots(source: object) -> set[str]:
    """Return the top-level packages that a file imports from outside, wherever it does."""
    found = {alias.name for node in source.places(ast.Import) for alias in node.names}
    found |= {node.module for node in source.places(ast.ImportFrom) if not node.level}
    return {name.split(".")[0] for name in found}


def test_every_part_has_a_rule(shipped: list) -> None:
    assert {_part(_module(PurePosixPath(str(s)))) for s in shipped} <= _ALLOWED.keys()


def test_dependencies_point_one_way(shipped: list) -> None:
    wrong = []
    for source in shipped:
        part = _part(_module(PurePosixPath(str(source))))
        for target in _imported(source):
            if target in {(), ("__package__",)}:
                continue
            other = _part(target)
            if other not in {part, *_ALLOWED[part]}:
                wrong.append(f"{source} imports {'.'.join(target)}")
    assert not wrong


def test_rule_finds_what_it_forbids() -> None:
    """Else the tests here would pass whatever is written."""
    from architectural_curvature.addon.geometry import errors  # noqa: F401

    class Bad:
        def places(self, *_kinds: type) -> list[ast.AST]:
            return [*ast.parse("from ...operators import segment\nfrom ..bridge import mesh").body]

        def __str__(self) -> str:
            return "addon/geometry/bad.py"

    assert list(_imported(Bad())) == [("operators",), ("addon", "bridge")]
    assert "bridge" not in _ALLOWED["geometry"]


@pytest.mark.parametrize("part", ["addon/geometry/", "addon/report/", "addon/export/"])
def test_mathematics_and_reports_know_nothing_of_blender(part: str, shipped: list) -> None:
    inside = [source for source in shipped if str(source).startswith(part)]
    assert inside
    assert not {
        str(source): _roots(source) & _BLENDER for source in inside if _roots(source) & _BLENDER
    }


def test_libigl_comes_in_by_one_door(shipped: list) -> None:
    assert [str(s) for s in shipped if "igl" in _roots(s)] == ["addon/geometry/libigl.py"]


def test_only_the_overlay_draws(shipped: list) -> None:
    drawing = [str(source) for source in shipped if _roots(source) & {"gpu", "blf", "gpu_extras"}]
    assert drawing
    assert all(path.startswith("addon/overlay/") for path in drawing)


def test_only_the_bridge_reads_meshes_and_writes_attributes(shipped: list) -> None:
    wrong = []
    for source in shipped:
        if str(source).startswith("addon/bridge/"):
            continue
        for node in source.places(ast.Attribute):
            is_bulk = node.attr in {"foreach_get", "foreach_set"}
            is_new = node.attr == "new" and getattr(node.value, "attr", "") == "attributes"
            if is_bulk or is_new:
                wrong.append(f"{source}:{node.lineno}")
    assert not wrong


def test_package_imports_itself_relatively(shipped: list) -> None:
    """Blender installs extensions under a name that nobody knows beforehand."""
    assert not {str(s): _roots(s) & _OUR_NAMES for s in shipped if _roots(s) & _OUR_NAMES}


def test_operators_do_not_import_one_another(shipped: list) -> None:
    wrong = [
        f"{source} imports {'.'.join(target)}"
        for source in shipped
        if str(source).startswith("operators/") and source.path.name != "__init__.py"
        for target in _imported(source)
        if target[0] == "operators"
    ]
    assert not wrong


def test_nobody_imports_the_registration(shipped: list) -> None:
    wrong = [
        str(source)
        for source in shipped
        if str(source) != "__init__.py" and ("addon", "registration") in _imported(source)
    ]
    assert not wrong


@pytest.mark.parametrize("path", ["__init__.py", "addon/__init__.py"])
def test_package_itself_imports_nothing(path: str, shipped: list) -> None:
    """That lets the geometry load without Blender."""
    (source,) = [each for each in shipped if str(each) == path]
    at_top = [node for node in source.tree.body if isinstance(node, ast.Import | ast.ImportFrom)]
    assert not at_top


@pytest.mark.parametrize("library", ["igl", "scipy"])
def test_libraries_are_not_imported_at_the_top_of_a_module(library: str, shipped: list) -> None:
    """They take long to load, and Blender's start must not pay for them."""
    wrong = [
        f"{source}:{node.lineno}"
        for source in shipped
        for node in source.tree.body
        if isinstance(node, ast.Import | ast.ImportFrom)
        and library in ast.unparse(node).replace(".", " ").split()
    ]
    assert not wrong
