# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Standard streams: results on stdout, progress and errors on stderr, and nothing in between."""

from __future__ import annotations

import ctypes
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TextIO

from ..geometry.types import Progress


@dataclass
class Console:
    """Where a command writes to.

    `results` is the real standard output; `is_quiet` silences progress but not errors.
    """

    results: TextIO
    is_quiet: bool

    def result(self, text: str) -> None:
        """Write a result."""
        self.results.write(text + "\n")
        self.results.flush()

    def progress(self, text: str) -> None:
        """Write a line of progress."""
        if not self.is_quiet:
            self.error(text)

    def percentages(self) -> Progress:
        """Return what writes the share that is done, a line per tenth."""
        written = -1

        def advance(share: float) -> None:
            nonlocal written
            tenth = int(10.0 * share + 1e-6)
            if tenth > written:
                written = tenth
                self.progress(f"  {10 * tenth:3d} %")

        return advance

    def error(self, text: str) -> None:
        """Write a line to the standard error."""
        sys.stderr.write(text + "\n")
        sys.stderr.flush()


def _flush_blender() -> None:
    """Empty the buffers of C, in which Blender's messages wait for the end where nobody looks."""
    ctypes.CDLL("ucrtbase" if sys.platform == "win32" else None).fflush(None)


@contextmanager
def console(is_quiet: bool) -> Iterator[Console]:
    """Give a console; what Blender and its importers write to stdout meanwhile is dropped.

    They report timings and internals there, between which nobody could read the results.
    """
    sys.stdout.flush()
    real = os.dup(1)
    with open(os.devnull, "wb") as nowhere, os.fdopen(real, "w", encoding="utf-8") as results:
        os.dup2(nowhere.fileno(), 1)
        try:
            yield Console(results, is_quiet)
        finally:
            sys.stdout.flush()
            results.flush()
            _flush_blender()
            os.dup2(results.fileno(), 1)


@contextmanager
def silent_importers() -> Iterator[None]:
    """Drop what importers write to the standard error: the errors that they raise say it again."""
    sys.stderr.flush()
    real = os.dup(2)
    with open(os.devnull, "wb") as nowhere:
        os.dup2(nowhere.fileno(), 2)
        try:
            yield
        finally:
            sys.stderr.flush()
            _flush_blender()
            os.dup2(real, 2)
            os.close(real)
