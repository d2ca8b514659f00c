# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of the files that a run writes, and whether it may."""

from __future__ import annotations

from argparse import Namespace
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

from ..report.files import FileRefusedError, check_writable


@dataclass(frozen=True)
class Outputs:
    """Files to write for one model."""

    output: Path | None
    image: Path | None


def plan_outputs(options: Namespace) -> list[Outputs]:
    """Return the files of every model, in the order of the models.

    Raises
    ------
    FileRefusedError
        If a file exists and must not be replaced, is one of the models, or cannot be written.
    """
    outputs = [
        Outputs(_named(options.output, suffix), _named(options.image, suffix))
        for suffix in _suffixes(options.models)
    ]
    inputs = {model.resolve() for model in options.models}
    wanted = [options.report, *(path for each in outputs for path in (each.output, each.image))]
    for path in wanted:
        if path is not None:
            _check(path, inputs, options.overwrite)
    return outputs


def _check(path: Path, inputs: set[Path], may_replace: bool) -> None:
    if path.resolve() in inputs:
        raise FileRefusedError(f"{path}: this is one of the models; choose another name")
    if path.exists() and not may_replace:
        raise FileRefusedError(f"{path}: the file exists; give --overwrite to replace it")
    check_writable(path)


def _suffixes(models: list[Path]) -> list[str]:
    """Return what tells the files of several models apart: their names, numbered where equal."""
    if len(models) == 1:
        return [""]
    stems = Counter(model.stem for model in models)
    seen: Counter[str] = Counter()
    suffixes = []
    for model in models:
        seen[model.stem] += 1
        number = f"-{seen[model.stem]}" if stems[model.stem] > 1 else ""
        suffixes.append(f"-{model.stem}{number}")
    return suffixes


def _named(path: Path | None, suffix: str) -> Path | None:
    return path and path.with_name(f"{path.stem}{suffix}{path.suffix}")
