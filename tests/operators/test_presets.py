# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Presets of the criterion: those of materials that ship, and users' own."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import bpy
import pytest
from bpy.types import PropertyGroup
from layout_stub import Layout
from models import RADIUS, add_surface, barrel, stored

FOLDER = "architectural_curvature"
MENU = "CURVATURE_MT_presets"


@pytest.fixture(autouse=True)
def _no_presets_of_users() -> Iterator[None]:
    yield
    # Blender gives a menu of presets the name of the last one, for all files.
    getattr(bpy.types, MENU).bl_label = "Presets"
    for path in _own_folder().glob("*.py"):
        path.unlink()


def _own_folder() -> Path:
    return Path(bpy.utils.user_resource("SCRIPTS", path=f"presets/{FOLDER}", create=True))


def _shipped() -> dict[str, Path]:
    """Return the files of the presets that ship by the names that menus show."""
    return {
        bpy.path.display_name(path.name, title_case=False): path
        for folder in bpy.utils.preset_paths(FOLDER)
        if Path(folder) != _own_folder()
        for path in Path(folder).glob("*.py")
    }


def _choose(path: Path) -> PropertyGroup:
    """Choose a preset as the menu does, and return the settings of the scene."""
    bpy.ops.script.execute_preset(filepath=str(path), menu_idname=MENU)
    return bpy.context.scene.curvature


def _listed() -> list[str]:
    """Return what the menu lists."""
    menu, layout = getattr(bpy.types, MENU), Layout()
    layout.texts.clear()
    drawn = SimpleNamespace(
        layout=layout,
        bl_idname=MENU,
        preset_subdir=menu.preset_subdir,
        preset_operator=menu.preset_operator,
    )
    drawn.path_menu = lambda *arguments, **options: bpy.types.Menu.path_menu(
        drawn, *arguments, **options
    )
    drawn.draw_preset = lambda context: bpy.types.Menu.draw_preset(drawn, context)
    menu.draw(drawn, bpy.context)
    return layout.buttons


@pytest.mark.parametrize(
    ("name", "radius"),
    [
        ("Cold-bent Glass 8 mm", 1500.0 * 0.008),
        ("Plywood 12.7 mm Across Grain", 6.0 * 0.3048),
        ("Plywood 19.1 mm Along Grain", 20.0 * 0.3048),
        ("Aircraft Plywood 3.2 mm 90 Degrees", 12.0 * 0.0254),
        ("Aluminum Composite 3 mm", 0.1),
    ],
)
def test_a_material_brings_criterion_radius_and_source(name: str, radius: float) -> None:
    settings = _choose(_shipped()[name])
    assert settings.criterion == "RADIUS"
    assert settings.smallest_radius == pytest.approx(radius, abs=5e-5)
    assert settings.criterion_preset == name
    assert settings.criterion_source


def test_every_preset_that_ships_can_be_chosen_and_has_a_source() -> None:
    assert len(_shipped()) > 20
    for name, path in _shipped().items():
        settings = _choose(path)
        assert settings.criterion_preset == name
        assert settings.smallest_radius > 0.0
        is_example = name.endswith("(Example)")
        assert is_example == settings.criterion_source.startswith("Example without a source")


def test_the_panel_size_is_left_alone() -> None:
    bpy.context.scene.curvature.panel_size = 1.5
    settings = _choose(_shipped()["Cold-bent Glass 8 mm"])
    assert settings.panel_size == 1.5
    settings.panel_size = 2.0
    assert settings.criterion_preset == "Cold-bent Glass 8 mm"


@pytest.mark.parametrize(
    ("name", "value"), [("smallest_radius", 11.0), ("criterion", "PANEL"), ("deviation", 0.01)]
)
def test_a_limit_set_by_hand_has_no_source_any_more(name: str, value: object) -> None:
    settings = _choose(_shipped()["Cold-bent Glass 8 mm"])
    setattr(settings, name, value)
    assert (settings.criterion_preset, settings.criterion_source) == ("", "")


def test_classes_and_report_follow_the_preset() -> None:
    """Composite of 3 mm bends to 0.1 m, to which a barrel of radius 2 m is flat; glass does not."""
    obj = add_surface(barrel)
    for name, expected in (("Aluminum Composite 3 mm", 0), ("Cold-bent Glass 6 mm", 1)):
        _choose(_shipped()[name])
        bpy.ops.curvature.segment()
        assert set(stored(obj, "curvature_class").tolist()) == {expected}
        block = json.loads(obj.data.curvature.report)
        assert block["criterion_preset"] == name
        assert block["criterion_source"] == bpy.context.scene.curvature.criterion_source


def test_other_limits_than_the_presets_are_not_said_to_be_of_it() -> None:
    obj = add_surface(barrel)
    _choose(_shipped()["Cold-bent Glass 8 mm"])
    bpy.ops.curvature.segment(smallest_radius=RADIUS)
    assert "criterion_preset" not in json.loads(obj.data.curvature.report)
    assert obj.data.curvature.criterion_preset == ""


def test_the_menu_lists_presets_by_name() -> None:
    names = _listed()
    assert set(names) == set(_shipped())
    assert names.index("Cold-bent Glass 8 mm") + 1 == names.index("Cold-bent Glass 10 mm")


@pytest.mark.parametrize(
    ("criterion", "limits"),
    [
        ("PANEL", {"panel_size": 1.5, "deviation": 0.005}),
        ("RADIUS", {"smallest_radius": 7.5}),
        ("RAW", {"gaussian_limit": 0.01, "mean_limit": 0.25}),
    ],
)
def test_presets_of_users_are_saved_listed_chosen_and_removed(
    criterion: str, limits: dict[str, float]
) -> None:
    settings = bpy.context.scene.curvature
    settings.criterion = criterion
    for name, value in limits.items():
        setattr(settings, name, value)
    assert bpy.ops.curvature.preset_add(name="North Roof", source="Mock-up, 2026") == {"FINISHED"}
    assert settings.criterion_preset == "North Roof"
    assert "North Roof" in _listed()

    (path,) = _own_folder().glob("*.py")
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    settings = _choose(path)
    assert settings.criterion == criterion
    assert {name: pytest.approx(getattr(settings, name)) for name in limits} == limits
    assert settings.criterion_preset == "North Roof"
    assert settings.criterion_source == "Mock-up, 2026"

    assert bpy.ops.curvature.preset_add(name="North Roof", remove_name=True) == {"FINISHED"}
    assert not path.exists()
    assert "North Roof" not in _listed()
    assert settings.criterion_preset == ""


def test_a_saved_material_is_written_as_those_that_ship() -> None:
    shipped = _shipped()["Cold-bent Glass 8 mm"]
    source = _choose(shipped).criterion_source
    bpy.ops.curvature.preset_add(name="My Glass", source=source)
    (path,) = _own_folder().glob("*.py")
    text = shipped.read_text(encoding="utf-8").replace("Cold-bent Glass 8 mm", "My Glass")
    assert path.read_text(encoding="utf-8") == text


def test_presets_that_ship_cannot_be_removed() -> None:
    settings = _choose(_shipped()["Cold-bent Glass 8 mm"])
    ended = bpy.ops.curvature.preset_add(name="Cold-bent Glass 8 mm", remove_name=True)
    assert ended == {"CANCELLED"}
    assert "Cold-bent Glass 8 mm" in _shipped()
    assert settings.criterion_preset == "Cold-bent Glass 8 mm"


def test_a_name_is_not_given_twice() -> None:
    _choose(_shipped()["Cold-bent Glass 8 mm"])
    assert bpy.ops.curvature.preset_add(name="Cold-bent Glass 8 mm") == {"CANCELLED"}
    assert not list(_own_folder().glob("*.py"))


def test_a_criterion_without_limits_is_not_saved() -> None:
    bpy.context.scene.curvature.criterion = "RAW"
    with pytest.raises(RuntimeError, match="Set the limits of the criterion first"):
        bpy.ops.curvature.preset_add(name="Nothing")
    assert not list(_own_folder().glob("*.py"))
