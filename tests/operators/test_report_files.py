# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Report files: the two formats agree, and a failure leaves what was there."""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import bpy
import pytest
from architectural_curvature.addon.report import files
from models import STRICT, add_surface, dome, saddle


@pytest.fixture(autouse=True)
def _models() -> None:
    add_surface(dome, "Dome, north")
    add_surface(saddle, 'Saddle "B" Ü')
    bpy.ops.curvature.segment(**STRICT)


def _rows(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8-sig", newline="") as text:
        return list(csv.DictReader(text))


def _export(path: Path) -> None:
    assert bpy.ops.curvature.export_report(filepath=str(path)) == {"FINISHED"}


def test_csv_has_the_columns_of_a_long_table(tmp_path: Path) -> None:
    _export(tmp_path / "report.csv")
    rows = _rows(tmp_path / "report.csv")
    assert list(rows[0]) == ["object", "group", "name", "measure", "value", "unit"]
    assert {row["object"] for row in rows} == {"Dome, north", 'Saddle "B" Ü'}


def test_csv_and_json_have_the_same_numbers(tmp_path: Path) -> None:
    _export(tmp_path / "report.csv")
    _export(tmp_path / "report.json")
    rows = _rows(tmp_path / "report.csv")
    found = {
        (row["object"], row["group"], row["name"], row["measure"]): row["value"] for row in rows
    }
    document = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    for block in document["objects"]:
        name = block["name"]
        assert float(found[name, "object", "", "area"]) == block["area"]
        for quantity in ("gaussian_curvature", "mean_curvature", "k1", "k2"):
            for label, value in block[quantity].items():
                assert float(found[name, "statistic", quantity, label]) == value
        for key, measures in block["classes"].items():
            for label, value in measures.items():
                text = found[name, "class", key, label]
                assert text == "" if value is None else float(text) == value
        for region in block["regions"]:
            text = found[name, "region", str(region["id"]), "area"]
            assert float(text) == region["area"]


def test_ending_may_be_in_capitals(tmp_path: Path) -> None:
    _export(tmp_path / "REPORT.JSON")
    assert json.loads((tmp_path / "REPORT.JSON").read_text(encoding="utf-8"))["schema"] == 1


@pytest.mark.parametrize("name", ["report", "report.txt", "report.xlsx", "report.json.bak"])
def test_other_endings_are_refused(name: str, tmp_path: Path, run: Callable[..., Any]) -> None:
    result, message = run("export_report", filepath=str(tmp_path / name))
    assert result == {"CANCELLED"}
    assert message.startswith(f"Error: {name}: reports end in .json, .csv or .html")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("ending", [".json", ".csv"])
def test_failure_leaves_the_old_file_and_no_other(
    ending: str, tmp_path: Path, run: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / f"report{ending}"
    path.write_text("old", encoding="utf-8")

    def fail(*_arguments: object) -> int:
        message = "no space left on device"
        raise OSError(28, message)

    monkeypatch.setattr(Path, "write_bytes", fail)
    result, message = run("export_report", filepath=str(path))
    assert result == {"CANCELLED"}
    assert "no space left on device" in message.lower()
    assert [each.name for each in tmp_path.iterdir()] == [path.name]
    assert path.read_text(encoding="utf-8") == "old"


def test_missing_folder_is_refused(tmp_path: Path, run: Callable[..., Any]) -> None:
    result, message = run("export_report", filepath=str(tmp_path / "nowhere" / "report.json"))
    assert result == {"CANCELLED"}
    assert "cannot write into the folder" in message
    assert not list(tmp_path.iterdir())


def test_folder_in_place_of_a_file_is_refused(tmp_path: Path, run: Callable[..., Any]) -> None:
    (tmp_path / "report.json").mkdir()
    result, message = run("export_report", filepath=str(tmp_path / "report.json"))
    assert result == {"CANCELLED"}
    assert "this is a folder" in message


def test_file_has_the_permissions_of_any_new_file(tmp_path: Path) -> None:
    _export(tmp_path / "report.json")
    usual = tmp_path / "usual"
    usual.touch()
    assert (tmp_path / "report.json").stat().st_mode == usual.stat().st_mode


@pytest.mark.filterwarnings("ignore:.*blend relative:RuntimeWarning")
def test_path_may_be_relative_to_the_open_file(tmp_path: Path) -> None:
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "design.blend"))
    assert bpy.ops.curvature.export_report(filepath="//report.json") == {"FINISHED"}
    document = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert {block["source"] for block in document["objects"]} == {
        os.fspath(tmp_path / "design.blend")
    }


def test_written_file_is_named(tmp_path: Path, run: Callable[..., Any]) -> None:
    assert run("export_report", filepath=str(tmp_path / "report.csv")) == (
        {"FINISHED"},
        "Info: Wrote report.csv",
    )


def test_every_format_is_listed_in_the_file_browser() -> None:
    properties = bpy.ops.curvature.export_report.get_rna_type().properties
    assert properties["filter_glob"].default == ";".join(f"*{each}" for each in files.FORMATS)
