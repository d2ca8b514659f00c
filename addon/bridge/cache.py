# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The newest analyses, kept so that a change of tolerance or color need not measure again.

What is kept can be thrown away at any time: the same model gives the same numbers again.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

from ..geometry.analysis import Analysis
from ..geometry.lines.tracer import LineField

#: Direction fields are large, and needed for the model at hand.
_MOST_FIELDS = 2

#: Together the kept analyses have at most this many corners, about 1 GB.
_MOST_CORNERS = 12_000_000

_kept: OrderedDict[str, Analysis] = OrderedDict()
_fields: OrderedDict[str, LineField] = OrderedDict()
_just_written: dict[str, str] = {}


def find(fingerprint: str) -> Analysis | None:
    """Return the analysis of a model, None where it is not kept."""
    if fingerprint in _kept:
        _kept.move_to_end(fingerprint)
    return _kept.get(fingerprint)


def keep(fingerprint: str, analysis: Analysis) -> None:
    """Keep an analysis, and let go of the oldest ones where there are too many."""
    _kept[fingerprint] = analysis
    _kept.move_to_end(fingerprint)
    while len(_kept) > 1 and _corner_count() > _MOST_CORNERS:
        _kept.popitem(last=False)


def find_field(key: str) -> LineField | None:
    """Return the direction field of a model, None where it is not kept."""
    return _fields.get(key)


def keep_field(key: str, lines: LineField) -> None:
    """Keep a direction field, and let go of the oldest where there are too many."""
    _fields[key] = lines
    while len(_fields) > _MOST_FIELDS:
        _fields.popitem(last=False)


@contextmanager
def trusted(fingerprints: Mapping[str, str]) -> Iterator[None]:
    """Take meshes, by their full names, for what was just analyzed, as long as the block runs.

    Reading a million faces again, to see that nothing has changed since, takes half a second.
    """
    _just_written.update(fingerprints)
    try:
        yield
    finally:
        _just_written.clear()


def just_written(mesh_name: str) -> Analysis | None:
    """Return the analysis of a mesh that cannot have changed since, None where it may have."""
    return find(_just_written.get(mesh_name, ""))


def clear() -> None:
    """Let go of all analyses."""
    _kept.clear()
    _fields.clear()


def _corner_count() -> int:
    return sum(len(analysis.surface.mesh.corner_vertex) for analysis in _kept.values())
