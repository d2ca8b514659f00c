# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `blender --command curvature`, called as Blender calls it."""

from __future__ import annotations

import ctypes
import importlib
import json
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryFile
from typing import IO

import bpy
import pytest
from models import add_surface, dome


@dataclass
class Ended:
    """How a run of the command ended."""

    status: int
    out: str
    err: str

    @property
    def report(self) -> dict:
        """The JSON on the standard output."""
        return json.loads(self.out)


@dataclass
class Streams:
    """What was written to the standard streams, Python's and Blender's own."""

    out: str = ""
    err: str = ""


Record = Callable[[], AbstractContextManager[Streams]]


@pytest.fixture
def recorded(capfd: pytest.CaptureFixture[str]) -> Record:
    """Record what a block writes as a pipe would get it.

    pytest gives Python a stream of its own in place of the standard output: what Blender prints
    through Python would go past the command's redirection, and loggers would keep the stream.
    """

    @contextmanager
    def record() -> Iterator[Streams]:
        streams = Streams()
        with capfd.disabled(), TemporaryFile() as out, TemporaryFile() as err:
            kept = os.dup(1), os.dup(2)
            _redirect(out.fileno(), err.fileno())
            try:
                yield streams
            finally:
                _redirect(*kept)
                for number in kept:
                    os.close(number)
                streams.out, streams.err = _text(out), _text(err)

    return record


def _redirect(out: int, err: int) -> None:
    sys.stdout.flush()
    sys.stderr.flush()
    ctypes.CDLL(None).fflush(None)
    os.dup2(out, 1)
    os.dup2(err, 2)


def _text(file: IO[bytes]) -> str:
    file.seek(0)
    return file.read().decode()


@pytest.fixture
def command(recorded: Record, extension: str) -> Callable[..., Ended]:
    """Run the command in this process: a process of its own takes seconds to start."""
    # By its own name: other tests may have enabled the extension anew, and with it new modules.
    cli = importlib.import_module(f"{extension}.addon.cli")

    def run(*arguments: object) -> Ended:
        with recorded() as streams:
            status = cli.main([str(argument) for argument in arguments])
        assert "Traceback" not in streams.err
        return Ended(status, streams.out, streams.err)

    return run


@pytest.fixture
def save(tmp_path: Path) -> Callable[[str], Path]:
    """Save what is in the scene to a Blender file in the test's folder."""

    def write(name: str) -> Path:
        path = tmp_path / name
        bpy.ops.wm.save_as_mainfile(filepath=str(path), copy=True)
        return path

    return write


@pytest.fixture
def roof(save: Callable[[str], Path]) -> Path:
    """A file with a dome of radius 2."""
    add_surface(dome)
    return save("roof.blend")
