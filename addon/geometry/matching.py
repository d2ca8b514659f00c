# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Names that stick: which region of a new segmentation is which of the one before."""

from __future__ import annotations

import itertools

import numpy as np

from .groups import sum_by_group
from .types import Floats, Indices

#: Regions are the same if they share this part of the area that either of them covers.
_ALIKE = 0.25


def match_regions(before: Indices, after: Indices, areas: Floats) -> Indices:
    """Return for every new region the old one that it continues.

    Regions that share most of their area are matched first, each with one other at most.

    Parameters
    ----------
    before, after : (m,) int64
        Region of every polygon of one mesh in two segmentations, -1 where there is none.
    areas : (m,) float64
        Of the polygons, in m².

    Returns
    -------
    (r,) int64
        The old region of each new one; -1 where it is new.
    """
    old_count, new_count = int(before.max(initial=-1)) + 1, int(after.max(initial=-1)) + 1
    match = np.full(new_count, -1, dtype=np.int64)
    both = (before >= 0) & (after >= 0)
    if not both.any():
        return match
    keys, compact = np.unique(before[both] * new_count + after[both], return_inverse=True)
    shared = sum_by_group(compact.reshape(-1), areas[both], len(keys))
    old, new = np.divmod(keys, new_count)
    old_area = sum_by_group(before[before >= 0], areas[before >= 0], old_count)
    new_area = sum_by_group(after[after >= 0], areas[after >= 0], new_count)
    union = old_area[old] + new_area[new] - shared
    likeness = np.divide(shared, union, out=np.zeros(len(keys)), where=union > 0.0)
    taken = np.zeros(old_count, dtype=np.bool_)
    # Equal ones in the order of their numbers: rounding must not decide.
    for pair in np.lexsort((new, old, -np.round(likeness, 9))):
        if likeness[pair] >= _ALIKE and match[new[pair]] < 0 and not taken[old[pair]]:
            match[new[pair]] = old[pair]
            taken[old[pair]] = True
    return match


def carry_names(
    names: list[str], before: Indices, after: Indices, areas: Floats, prefix: str = "Region"
) -> list[str]:
    """Return the names of new regions: those of the old ones that they continue, else new ones.

    Parameters
    ----------
    names : list of str
        Of the old regions, by number.
    before, after, areas
        As in `match_regions`.
    prefix : str
        New names are this and the smallest number that no region has.

    Returns
    -------
    list of str
        No name twice, if there was none twice before.
    """
    match: list[int] = match_regions(before, after, areas).tolist()
    known = [names[old] if 0 <= old < len(names) else "" for old in match]
    used = {*names, *known}
    free = (name for name in (f"{prefix} {i}" for i in itertools.count(1)) if name not in used)
    return [name or next(free) for name in known]
