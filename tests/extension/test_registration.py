# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Enabled, used and disabled twice, the extension leaves Blender as it found it."""

import importlib
from collections.abc import Iterator
from pathlib import Path

import addon_utils
import bpy
import pytest

_OWNERS = ("Scene", "Object", "Mesh", "Collection", "Material", "WindowManager", "Screen")
_SPACES = ("SpaceView3D", "SpaceProperties", "SpaceImageEditor")


def _state_of_blender() -> dict[str, object]:
    """What an extension may change and Python can see."""
    handlers = {
        name: list(getattr(bpy.app.handlers, name))
        for name in dir(bpy.app.handlers)
        if isinstance(getattr(bpy.app.handlers, name), list)
    }
    properties = {
        owner: sorted(getattr(bpy.types, owner).bl_rna.properties.keys()) for owner in _OWNERS
    }
    menus = {
        name: [str(draw) for draw in getattr(getattr(bpy.types, name).draw, "_draw_funcs", ())]
        for name in dir(bpy.types)
        if "_MT_" in name or "_HT_" in name or "_PT_" in name
    }
    return {
        "types": sorted(dir(bpy.types)),
        "handlers": handlers,
        "properties": properties,
        "attributes": {owner: sorted(dir(getattr(bpy.types, owner))) for owner in _OWNERS},
        "menus": menus,
        "presets": bpy.utils.preset_paths("architectural_curvature"),
        "operators": sorted(dir(bpy.ops.curvature)),
    }


@pytest.fixture
def handles(monkeypatch: pytest.MonkeyPatch) -> dict[int, object]:
    """The draw handlers and commands that exist, of which Blender keeps no list to look at."""
    # By identity: a handle that was removed has another name.
    alive: dict[int, object] = {}

    def watch(owner: object, add: str, remove: str) -> None:
        adding, removing = getattr(owner, add), getattr(owner, remove)

        def watched_adding(*arguments: object) -> object:
            handle = adding(*arguments)
            alive[id(handle)] = handle
            return handle

        def watched_removing(handle: object, *arguments: object) -> None:
            removing(handle, *arguments)
            del alive[id(handle)]

        monkeypatch.setattr(owner, add, watched_adding)
        monkeypatch.setattr(owner, remove, watched_removing)

    watch(bpy.utils, "register_cli_command", "unregister_cli_command")
    for space in _SPACES:
        watch(getattr(bpy.types, space), "draw_handler_add", "draw_handler_remove")
    return alive


@pytest.fixture(autouse=True)
def _enabled_afterwards(extension: str) -> Iterator[None]:
    yield
    addon_utils.enable(extension, default_set=True)


def _use() -> None:
    bpy.ops.mesh.primitive_uv_sphere_add()
    assert bpy.ops.curvature.segment() == {"FINISHED"}
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)


def test_enabling_using_and_disabling_twice_leaves_nothing(
    extension: str, handles: dict[int, object]
) -> None:
    addon_utils.disable(extension)
    before = _state_of_blender()
    for _ in range(2):
        addon_utils.enable(extension)
        assert hasattr(bpy.types.Scene, "curvature")
        assert handles, "nothing was registered that this test can see"
        _use()
        addon_utils.disable(extension)
        assert _state_of_blender() == before
        assert not handles


def test_disabling_after_a_file_was_loaded_leaves_nothing(
    extension: str, tmp_path: Path, handles: dict[int, object]
) -> None:
    """Loading a file drops handlers that are not persistent: removing them again must not fail."""
    addon_utils.disable(extension)
    before = _state_of_blender()
    addon_utils.enable(extension)
    file = str(tmp_path / "saved.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.open_mainfile(filepath=file)
    addon_utils.disable(extension)
    assert _state_of_blender() == before
    assert not handles


def test_failed_registration_leaves_nothing(
    extension: str, handles: dict[int, object], monkeypatch: pytest.MonkeyPatch
) -> None:
    """All modules are registered, or none."""
    registration = importlib.import_module(f"{extension}.addon.registration")
    addon_utils.disable(extension)
    before = _state_of_blender()

    def fail() -> None:
        message = "on purpose"
        raise RuntimeError(message)

    monkeypatch.setattr(registration._MODULES[-1], "register", fail)
    with pytest.raises(RuntimeError, match="on purpose"):
        registration.register()
    assert _state_of_blender() == before
    assert not handles
