# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sources of the extension, parsed."""

from __future__ import annotations

import ast
from dataclasses import dataclass
from pathlib import Path

import pytest

_SHIPPED = ("__init__.py", "addon/**/*.py", "operators/**/*.py")
_ALL = (*_SHIPPED, "tests/**/*.py", "tools/**/*.py", "dev.py")


@dataclass(frozen=True)
class Source:
    """A Python file: its path from the root, its text and its syntax tree."""

    path: Path
    text: str
    tree: ast.Module

    def places(self, *kinds: type[ast.AST]) -> list[ast.AST]:
        """Return the nodes of some kinds."""
        return [node for node in ast.walk(self.tree) if isinstance(node, kinds)]

    def __str__(self) -> str:
        return self.path.as_posix()


def _parse(root: Path, patterns: tuple[str, ...]) -> list[Source]:
    paths = sorted(path for pattern in patterns for path in root.glob(pattern))
    texts = {path: path.read_text(encoding="utf-8") for path in paths}
    return [Source(path.relative_to(root), text, ast.parse(text)) for path, text in texts.items()]


@pytest.fixture(scope="session")
def shipped(repository: Path) -> list[Source]:
    """What users get."""
    return _parse(repository, _SHIPPED)


@pytest.fixture(scope="session")
def sources(repository: Path) -> list[Source]:
    """Everything, tests and tools included."""
    return _parse(repository, _ALL)
