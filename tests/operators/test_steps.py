# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Long work runs beside the window: it tells how far it is, and can be stopped."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Generator
from typing import Any

import bpy
import pytest
from architectural_curvature.addon import steps, tasks
from architectural_curvature.addon.choices import analysis_settings, segmentation_settings
from architectural_curvature.addon.tracing.lines import trace_objects
from architectural_curvature.addon.tracing.settings import LineSettings, Plan, families_of
from models import add_surface, dome, own_attributes, saddle

Advance = Callable[[float], None]
Task = Generator[steps.Work, Any, Any]


def test_a_task_gets_what_its_work_found_and_returns_a_result() -> None:
    def task() -> Task:
        one = yield steps.Work(lambda _: 20, 0.0, 0.5)
        two = yield steps.Work(lambda _: one + 1, 0.5, 1.0)
        return 2 * two

    shares: list[float] = []
    assert steps.complete(task(), shares.append) == 42
    assert shares[-1] == 1.0


def test_work_runs_on_a_thread_of_its_own_and_the_task_does_not() -> None:
    here = threading.get_ident()
    seen: list[int] = []

    def task() -> Task:
        seen.append(threading.get_ident())
        seen.append((yield steps.Work(lambda _: threading.get_ident(), 0.0, 1.0)))

    steps.complete(task())
    assert seen[0] == here
    assert seen[1] != here


def test_the_share_of_the_work_is_a_stretch_of_the_task() -> None:
    told, go_on = threading.Event(), threading.Event()

    def work(advance: Advance) -> None:
        advance(0.5)
        told.set()
        go_on.wait(10.0)

    def task() -> Task:
        yield steps.Work(work, 0.2, 0.6)

    run = steps.Run(task())
    assert not run.advance(0.0)
    assert told.wait(10.0)
    assert run.share == pytest.approx(0.4)
    go_on.set()
    while not run.advance(0.1):
        pass
    assert run.share == 1.0


def test_what_the_work_raises_is_raised_in_the_task() -> None:
    def task() -> Task:
        try:
            yield steps.Work(lambda _: 1 // 0, 0.0, 1.0)
        except ZeroDivisionError:
            return "caught"

    assert steps.complete(task()) == "caught"


def test_cancelling_stops_the_work_and_lets_the_task_clean_up() -> None:
    cleaned: list[bool] = []

    def work(advance: Advance) -> None:
        for _ in range(10_000):
            advance(0.1)
            time.sleep(0.001)
        raise AssertionError("nobody stopped it")

    def task() -> Task:
        try:
            yield steps.Work(work, 0.0, 1.0)
        finally:
            cleaned.append(True)

    run = steps.Run(task())
    assert not run.advance(0.05)
    run.cancel()
    assert cleaned == [True]
    assert run.is_finished
    assert run.result is None


def test_a_cancelled_segmentation_leaves_the_model_as_it_was() -> None:
    obj, context = add_surface(dome), bpy.context
    before = set(bpy.data.objects)
    task = tasks.segment_objects(
        context, [obj], analysis_settings(context), segmentation_settings(context)
    )
    run = steps.Run(task)
    run.advance(0.0)
    run.cancel()
    assert not own_attributes(obj)
    assert not obj.data.curvature.fingerprint
    assert set(bpy.data.objects) == before
    # Another run finds nothing in its way.
    assert bpy.ops.curvature.segment() == {"FINISHED"}
    assert obj.data.curvature.is_segmented


@pytest.mark.parametrize("share", [0.0, 0.5])
def test_cancelled_tracing_leaves_the_model_as_it_was(share: float) -> None:
    obj, context = add_surface(saddle), bpy.context
    before = set(bpy.data.objects)
    lines = LineSettings(families_of("PRINCIPAL", "BOTH"))
    plan = Plan(analysis_settings(context), segmentation_settings(context), lines)
    run = steps.Run(trace_objects(context, [obj], plan))
    run.advance(0.0)
    while run.share < share:
        run.advance(0.0)
    assert not run.is_finished
    run.cancel()
    assert not own_attributes(obj)
    assert set(bpy.data.objects) == before
    # Another run finds nothing in its way.
    assert bpy.ops.curvature.segment() == {"FINISHED"}
