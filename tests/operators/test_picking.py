# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Single lines are shown under the mouse and kept by a click; all but the mouse is tested here."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

import bpy
import numpy as np
import pytest
from architectural_curvature.addon import steps
from architectural_curvature.addon.choices import line_plan
from architectural_curvature.addon.geometry.lines.lines import CurvatureLines
from architectural_curvature.addon.overlay import preview
from architectural_curvature.addon.tracing.picking import Picker, prepare_picker
from architectural_curvature.operators import pick_lines
from bpy.types import Object
from mathutils import Euler, Matrix
from models import RADIUS, add_surface, barrel, only_select, own_attributes, plate


@pytest.fixture
def vault() -> Object:
    """A barrel vault along y that stands turned and stretched in the world."""
    obj = add_surface(barrel, "Vault", 64)
    obj.matrix_world = Matrix.LocRotScale((5.0, 1.0, 0.0), Euler((0.0, 0.0, 0.5)), (2.0, 2.0, 2.0))
    bpy.context.view_layer.update()
    return obj


def _picker(obj: Object) -> Picker:
    return steps.complete(prepare_picker(bpy.context, obj, line_plan(bpy.context)))


DOWN = np.array([0.0, 0.0, -1.0])
RIDGE = np.array([5.0, 1.0, 2.0 * RADIUS])


def _lines_below(picker: Picker, place: np.ndarray) -> CurvatureLines:
    seen = picker.seen(place - 50.0 * DOWN, DOWN)
    assert seen is not None
    assert seen.advance(np.inf)
    return seen.lines()


def test_both_lines_run_through_what_is_seen(vault: Object) -> None:
    picker = _picker(vault)
    lines = _lines_below(picker, RIDGE)
    assert sorted(lines.family.tolist()) == [1, 2]
    for points in picker.in_world(lines):
        assert np.linalg.norm(points - RIDGE, axis=1).min() < 0.15
    ruling = picker.in_world(lines)[lines.family.tolist().index(2)]
    np.testing.assert_allclose(np.ptp(ruling[:, 2]), 0.0, atol=0.01)
    assert picker.seen(RIDGE + 50.0 * DOWN, DOWN) is None


def test_model_is_seen_in_edit_mode_too(vault: Object) -> None:
    bpy.ops.object.mode_set(mode="EDIT")
    assert _lines_below(_picker(vault), RIDGE).count == 2
    assert vault.mode == "EDIT"


def test_looking_changes_nothing_and_keeping_adds_lines(vault: Object) -> None:
    picker = _picker(vault)
    lines = _lines_below(picker, RIDGE)
    assert not own_attributes(vault)
    assert list(bpy.data.objects) == [vault]
    picker.keep(bpy.context, lines)
    picker.keep(bpy.context, lines)
    assert len(bpy.data.objects["Vault Picked Lines 1"].data.splines) == 2
    assert len(bpy.data.objects["Vault Picked Lines 2"].data.splines) == 2
    assert "curvature_k1" in own_attributes(vault)
    bpy.ops.curvature.clear()
    assert list(bpy.data.objects) == [vault]


def test_tracing_lines_leaves_those_that_were_picked(vault: Object) -> None:
    picker = _picker(vault)
    picker.keep(bpy.context, _lines_below(picker, RIDGE))
    only_select(vault)
    bpy.ops.curvature.trace_lines(spacing=1.0)
    assert len(bpy.data.objects["Vault Picked Lines 1"].data.splines) == 1


def test_scripts_are_told_what_to_use(vault: Object, run: Callable[..., Any]) -> None:
    del vault
    result, text = run("pick_lines")
    assert result == {"CANCELLED"}
    assert text == "Error: Picking needs a 3D viewport: use Trace Through Points in scripts"


def test_active_mesh_is_asked_for(vault: Object) -> None:
    bpy.context.view_layer.objects.active = None
    with pytest.raises(RuntimeError, match="Make a mesh object the active one"):
        bpy.ops.curvature.pick_lines()
    vault.select_set(False)
    with pytest.raises(RuntimeError, match="Select a mesh object"):
        bpy.ops.curvature.pick_lines()


def test_preview_is_drawn_until_it_is_hidden() -> None:
    line = preview.PreviewLine(np.eye(3), True, (1.0, 0.0, 0.0, 1.0))
    preview.show([line])
    preview.show([line, line])
    assert preview.shown() == [line, line]
    preview.hide()
    preview.hide()
    assert preview.shown() == []


@pytest.mark.parametrize("is_closed", [True, False])
def test_preview_lines_are_lifted_towards_the_eye(is_closed: bool) -> None:
    eye = np.array([0.0, 0.0, 10.0])
    ends = preview.segments(preview.PreviewLine(np.eye(3), is_closed, (1.0, 0.0, 0.0, 1.0)), eye)
    assert len(ends) == (6 if is_closed else 4)
    before = np.linalg.norm(np.eye(3)[0] - eye)
    assert np.linalg.norm(ends[0] - eye) == pytest.approx(0.998 * before)
    np.testing.assert_array_equal(ends[1], ends[2])


class _Session:
    """The operator as Blender runs it, with a mouse that is always on the ridge of the vault."""

    def __init__(self, obj: Object, monkeypatch: pytest.MonkeyPatch) -> None:
        methods = vars(pick_lines.CURVATURE_OT_pick_lines)
        self.operator = type("Operator", (), {k: v for k, v in methods.items() if callable(v)})()
        self.operator.bl_label = "Pick Lines"
        self.operator.report = lambda _kind, text: self.texts.append(text)
        self.operator._picker = self.operator._pointed = self.operator._timer = None
        self.operator._mouse = (50, 50)
        self.operator._kept = 0
        self.texts: list[str] = []
        plan = line_plan(bpy.context)
        self.operator._preparing = steps.Run(prepare_picker(bpy.context, obj, plan))
        self.operator._preparing.advance(0.0)
        self.context = SimpleNamespace(
            region=SimpleNamespace(width=100, height=100),
            window_manager=SimpleNamespace(event_timer_remove=lambda _: None, windows=()),
            workspace=SimpleNamespace(status_text_set=self.texts.append),
            scene=bpy.context.scene,
            view_layer=bpy.context.view_layer,
            evaluated_depsgraph_get=bpy.context.evaluated_depsgraph_get,
        )
        monkeypatch.setattr(pick_lines, "ray_through", lambda *_: (RIDGE - 50.0 * DOWN, DOWN))

    def send(self, kind: str, value: str = "PRESS", x: int = 50) -> set[str]:
        event = SimpleNamespace(
            type=kind, value=value, mouse_region_x=x, mouse_region_y=50, alt=False
        )
        return self.operator.modal(self.context, event)

    def wait(self, is_done: Callable[[], bool]) -> None:
        for _ in range(600):
            if is_done():
                return
            assert self.send("TIMER") == {"RUNNING_MODAL"}
            time.sleep(0.05)
        pytest.fail("the work does not end")


@pytest.fixture
def session(vault: Object, monkeypatch: pytest.MonkeyPatch) -> Iterator[_Session]:
    started = _Session(vault, monkeypatch)
    yield started
    preview.hide()


def test_mouse_may_rest_before_the_model_is_ready(session: _Session) -> None:
    session.wait(lambda: len(preview.shown()) == 2)
    session.send("ESC")


def test_mouse_shows_and_click_keeps_both_lines(session: _Session) -> None:
    session.wait(lambda: session.operator._picker is not None)
    assert session.send("MOUSEMOVE") == {"RUNNING_MODAL"}
    session.wait(lambda: len(preview.shown()) == 2)
    assert session.send("LEFTMOUSE") == {"RUNNING_MODAL"}
    assert session.send("LEFTMOUSE", "RELEASE") == {"RUNNING_MODAL"}
    assert len(bpy.data.objects["Vault Picked Lines 1"].data.splines) == 1
    assert session.texts[-1].startswith("Pick Lines: 2 lines kept")
    assert session.send("ESC") == {"FINISHED"}
    assert session.texts[-1] == "Kept 2 lines"
    assert preview.shown() == []


def test_click_keeps_whole_lines_before_they_are_shown(
    session: _Session, vault: Object, monkeypatch: pytest.MonkeyPatch
) -> None:
    session.wait(lambda: session.operator._picker is not None)
    monkeypatch.setattr(pick_lines, "_PATIENCE", -1.0)
    session.send("MOUSEMOVE")
    assert not session.operator._pointed.is_done
    session.send("LEFTMOUSE")
    session.send("ESC")
    whole = _lines_below(_picker(vault), RIDGE)
    kept = bpy.data.objects["Vault Picked Lines 2"].data.get("curvature_lengths")
    assert kept[0] == pytest.approx(whole.length[whole.family == 2][0])


def test_status_tells_where_there_are_no_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    started = _Session(add_surface(plate, "Plate"), monkeypatch)
    above = np.array([0.1, 0.1, 5.0])
    monkeypatch.setattr(pick_lines, "ray_through", lambda *_: (above, DOWN))
    started.wait(lambda: started.operator._picker is not None)
    assert "No Lines Here" in started.texts[-1]
    monkeypatch.setattr(pick_lines, "ray_through", lambda *_: (above, -DOWN))
    started.send("MOUSEMOVE")
    assert "Click: Keep the Lines" in started.texts[-1]
    started.send("LEFTMOUSE")
    assert started.send("ESC") == {"CANCELLED"}


@pytest.mark.parametrize("end", ["ESC", "RIGHTMOUSE"])
def test_ending_without_a_click_changes_nothing(end: str, session: _Session, vault: Object) -> None:
    session.wait(lambda: session.operator._picker is not None)
    session.send("MOUSEMOVE")
    session.wait(lambda: len(preview.shown()) == 2)
    assert session.send(end) == {"CANCELLED"}
    assert list(bpy.data.objects) == [vault]
    assert preview.shown() == []


def test_analysis_can_be_cancelled(session: _Session, vault: Object) -> None:
    assert session.send("LEFTMOUSE") == {"RUNNING_MODAL"}
    assert session.send("ESC") == {"CANCELLED"}
    assert not own_attributes(vault)


@pytest.mark.parametrize("kind", ["MIDDLEMOUSE", "WHEELUPMOUSE", "NUMPAD_1"])
def test_the_view_can_be_moved(kind: str, session: _Session) -> None:
    assert session.send(kind) == {"PASS_THROUGH"}
    session.send("ESC")


def test_clicks_beside_the_view_belong_to_others(session: _Session) -> None:
    assert session.send("LEFTMOUSE", x=150) == {"PASS_THROUGH"}
    session.send("ESC")
