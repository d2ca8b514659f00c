# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tasks in steps: Blender is read and written on its own thread, arrays are computed on another.

So a window stays alive while a model is measured, and Esc is heard. A script waits for the same
steps.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from concurrent.futures import Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from typing import Any, Generic, TypeVar, cast

from .geometry.types import Progress

Result = TypeVar("Result")
Steps = Generator["Work", Any, Result]
"""A task: yields work, is sent what came of it, and returns the task's result."""

#: Seconds between two looks at a work's progress.
_POLL = 0.1


class CancelledError(Exception):
    """The user has had enough."""


@dataclass(frozen=True)
class Work:
    """Something to compute that does not touch Blender.

    `run` takes a function that it tells the share of the work that is done, 0 to 1; of the whole
    task it is the stretch from `start` to `end`.
    """

    run: Callable[[Progress], Any]
    start: float
    end: float


class Run(Generic[Result]):
    """A task on its way.

    Parameters
    ----------
    steps : generator of Work
        Its own code runs on the thread that calls `advance`.

    Attributes
    ----------
    share : float
        How much is done, 0 to 1.
    is_finished : bool
        Whether the task has ended, with its `result` or without.
    """

    def __init__(self, steps: Steps[Result]) -> None:
        self.share = 0.0
        self.is_finished = False
        self.result: Result | None = None
        self._steps = steps
        self._is_cancelled = False
        self._worker = ThreadPoolExecutor(1, thread_name_prefix="Curvature")
        self._pending: Future[Any] | None = None

    def advance(self, seconds: float) -> bool:
        """Go on until the task ends or its work takes this long; return whether it has ended.

        Raises
        ------
        Exception
            Whatever the task raises.
        """
        while not self.is_finished:
            if self._pending is not None and not wait([self._pending], seconds).done:
                return False
            self._begin_next()
        return True

    def cancel(self) -> None:
        """Stop the work at hand; the task cleans up after itself and has no result."""
        self._is_cancelled = True
        self.is_finished = True
        self._worker.shutdown()
        self._steps.close()

    def _begin_next(self) -> None:
        before, self._pending = self._pending, None
        # Should the task raise, it has ended.
        self.is_finished = True
        try:
            if before is None:
                work = next(self._steps)
            elif (error := before.exception()) is not None:
                work = self._steps.throw(error)
            else:
                work = self._steps.send(before.result())
        except StopIteration as end:
            self.result, self.share = end.value, 1.0
            self._worker.shutdown()
            return
        self.is_finished = False
        self._pending = self._worker.submit(work.run, self._listener(work))

    def _listener(self, work: Work) -> Progress:
        def advance(share: float) -> None:
            self.share = work.start + share * (work.end - work.start)
            if self._is_cancelled:
                raise CancelledError

        return advance


def complete(steps: Steps[Result], on_progress: Progress | None = None) -> Result:
    """Wait for a task to end and return its result.

    Parameters
    ----------
    steps : generator of Work
    on_progress : callable, optional
        Receives the share that is done, several times a second.
    """
    run = Run(steps)
    try:
        while not run.advance(_POLL):
            if on_progress:
                on_progress(run.share)
    finally:
        # After Ctrl C, for one, the work must not go on alone.
        if not run.is_finished:
            run.cancel()
    if on_progress:
        on_progress(1.0)
    return cast("Result", run.result)
