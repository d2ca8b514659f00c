# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files are written whole or not at all, and refusals say what to do."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from architectural_curvature.addon.report import files
from architectural_curvature.addon.report.document import build_document
from architectural_curvature.addon.report.files import (
    FileRefusedError,
    check_format,
    check_writable,
    write_report,
    written_whole,
)

DOCUMENT = build_document("0.1.0", "4.5.3", {}, [])


def test_the_ending_chooses_the_format(tmp_path: Path) -> None:
    write_report(tmp_path / "a.json", DOCUMENT)
    write_report(tmp_path / "b.CSV", DOCUMENT)
    assert (tmp_path / "a.json").read_bytes().startswith(b"{\n")
    # Spreadsheets know UTF-8 by this signature.
    assert (tmp_path / "b.CSV").read_bytes().startswith(b"\xef\xbb\xbfobject,")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.json", "b.CSV"]


@pytest.mark.parametrize("name", ["report.txt", "report", "report.json.bak"])
def test_unknown_endings_are_refused_with_the_known_ones(tmp_path: Path, name: str) -> None:
    with pytest.raises(FileRefusedError, match=r"reports end in \.json, \.csv or \.html, not in"):
        write_report(tmp_path / name, DOCUMENT)
    assert not list(tmp_path.iterdir())


def test_endings_count_in_any_case() -> None:
    assert check_format(Path("a.JSON")) == ".json"


def test_a_failing_block_leaves_the_old_file_and_nothing_else(tmp_path: Path) -> None:
    target = tmp_path / "old.json"
    target.write_text("old")

    def fail() -> None:
        with written_whole(target) as temporary:
            temporary.write_text("half")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        fail()
    assert target.read_text() == "old"
    assert list(tmp_path.iterdir()) == [target]


def test_an_empty_result_leaves_the_old_file(tmp_path: Path) -> None:
    target = tmp_path / "old.json"
    target.write_text("old")
    with written_whole(target):
        pass
    assert target.read_text() == "old"


def test_a_report_that_json_refuses_leaves_no_file(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="JSON"):
        write_report(tmp_path / "a.json", DOCUMENT | {"x": float("nan")})
    assert not list(tmp_path.iterdir())


def test_the_temporary_file_stands_beside_the_target_and_keeps_its_ending(tmp_path: Path) -> None:
    with written_whole(tmp_path / "picture.png") as temporary:
        assert temporary.parent == tmp_path
        assert temporary.suffix == ".png"
        temporary.write_bytes(b"x")
    assert [path.name for path in tmp_path.iterdir()] == ["picture.png"]


def test_a_missing_folder_is_named(tmp_path: Path) -> None:
    target = tmp_path / "none" / "a.json"
    with pytest.raises(FileRefusedError, match="cannot write into the folder") as caught:
        write_report(target, DOCUMENT)
    assert str(target.parent) in str(caught.value)


def test_a_folder_is_no_file(tmp_path: Path) -> None:
    with pytest.raises(FileRefusedError, match="this is a folder; give the name of a file"):
        check_writable(tmp_path)


def test_a_folder_that_cannot_be_written_to_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Rights do not hold for the administrator, whom tests may run as.
    def refuse(**_options: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(files.tempfile, "mkstemp", refuse)
    with pytest.raises(FileRefusedError, match=r"\(Permission denied\): choose another one"):
        check_writable(tmp_path / "a.json")


def test_checking_leaves_nothing_behind(tmp_path: Path) -> None:
    check_writable(tmp_path / "a.json")
    assert not list(tmp_path.iterdir())


@pytest.mark.skipif(os.name == "nt", reason="Windows has no file modes")
def test_files_can_be_read_by_whom_the_user_allows(tmp_path: Path) -> None:
    mask = os.umask(0o022)
    try:
        write_report(tmp_path / "a.json", DOCUMENT)
    finally:
        os.umask(mask)
    assert (tmp_path / "a.json").stat().st_mode & 0o777 == 0o644
