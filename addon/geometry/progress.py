# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress of work that has parts."""

from __future__ import annotations

from .types import Progress


def part_of(on_progress: Progress | None, start: float, end: float) -> Progress:
    """Return what a part of the work reports to, which is a stretch of the whole.

    Parameters
    ----------
    on_progress : callable or None
        Receives the share of the whole work; None if nobody listens.
    start, end : float
        Shares of the whole work at which the part starts and ends.

    Returns
    -------
    callable
        Receives the share of the part that is done; raises what the listener raises.
    """

    def report(share: float) -> None:
        if on_progress:
            on_progress(start + share * (end - start))

    return report
