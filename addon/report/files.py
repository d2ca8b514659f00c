# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are written whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from .document import csv_text, json_text
from .html import Picture, html_text

FORMATS = (".json", ".csv", ".html")
"""File endings that reports can have."""


class FileRefusedError(OSError):
    """A file cannot be written; the message names it, the cause and the way out."""


def write_report(
    path: Path,
    document: dict[str, Any],
    pictures: Sequence[Picture] = (),
    colors: Mapping[str, str] | None = None,
) -> None:
    """Write a report in the format that the ending of its file name stands for.

    Parameters
    ----------
    path : Path
    document : dict
        See `build_document`.
    pictures : sequence of Picture
        For HTML; the other formats are figures only.
    colors : mapping, optional
        CSS colors of the classes by their keys in reports, for HTML.

    Raises
    ------
    FileRefusedError
        If the ending is not known or the folder cannot be written to.
    """
    ending = check_format(path)
    if ending == ".html":
        text = html_text(document, pictures, colors)
    else:
        text = json_text(document) if ending == ".json" else csv_text(document)
    # The signature lets spreadsheets read the file as UTF-8; JSON must not have one.
    encoding = "utf-8-sig" if ending == ".csv" else "utf-8"
    with written_whole(path) as temporary:
        temporary.write_bytes(text.encode(encoding))


def check_format(path: Path) -> str:
    """Return the ending of a report's name in lower case, or refuse it."""
    ending = path.suffix.lower()
    if ending not in FORMATS:
        raise FileRefusedError(
            f"{path.name}: reports end in {', '.join(FORMATS[:-1])} or {FORMATS[-1]}, "
            f"not in '{path.suffix}'"
        )
    return ending


def check_writable(path: Path) -> None:
    """Refuse a file whose folder is missing or cannot be written to.

    Raises
    ------
    FileRefusedError
    """
    with written_whole(path):
        pass


@contextmanager
def written_whole(path: Path) -> Iterator[Path]:
    """Give a temporary file beside a target; it takes the target's place if the block succeeds.

    A block that leaves the temporary file empty leaves the target alone. The temporary name keeps
    the ending, from which Blender takes the format.

    Raises
    ------
    FileRefusedError
        If the folder is missing or cannot be written to, or writing fails, as on a full disk.
    """
    if path.is_dir():
        raise FileRefusedError(f"{path}: this is a folder; give the name of a file")
    try:
        handle, name = tempfile.mkstemp(
            suffix=path.suffix, prefix=f".{path.stem}-", dir=path.parent
        )
    except OSError as error:
        raise FileRefusedError(
            f"{path}: cannot write into the folder {path.parent} ({error.strerror}): "
            "choose another one"
        ) from error
    os.close(handle)
    temporary = Path(name)
    try:
        yield temporary
        if temporary.exists() and temporary.stat().st_size:
            temporary.chmod(0o666 & ~_umask())
            temporary.replace(path)
    except FileRefusedError:
        raise
    except OSError as error:
        raise FileRefusedError(f"{path}: it cannot be written ({error.strerror})") from error
    finally:
        temporary.unlink(missing_ok=True)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
