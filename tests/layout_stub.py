# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A layout that panels draw into without a window; it knows what Blender would refuse."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import bpy

_ICONS = set(bpy.types.UILayout.bl_rna.functions["label"].parameters["icon"].enum_items.keys())
_CONTAINERS = ("row", "column", "box", "split", "grid_flow", "column_flow", "menu_pie")


class Layout:
    """Keeps what was drawn in `texts`, `properties`, `operators` and `buttons`, their texts."""

    def __init__(self, parent: Layout | None = None, context: object = None) -> None:
        self.context: Any = context or (parent.context if parent else bpy.context)
        self.texts: list[str] = parent.texts if parent else []
        self.properties: list[str] = parent.properties if parent else []
        self.operators: list[str] = parent.operators if parent else []
        self.buttons: list[str] = parent.buttons if parent else []

    def __getattr__(self, name: str) -> Callable[..., Layout]:
        if name not in _CONTAINERS:
            message = f"panels of ours do not use layout.{name}"
            raise AttributeError(message)
        return lambda **_options: Layout(self)

    def label(self, *, text: str = "", icon: str = "NONE") -> None:
        """Keep a text."""
        assert icon in _ICONS, icon
        self.texts.append(text)

    def separator(self, **_options: object) -> None:
        """Leave a gap."""

    def menu(self, name: str, *, text: str = "", icon: str = "NONE") -> None:
        """Keep what a menu shows, which must exist."""
        assert icon in _ICONS, icon
        assert hasattr(bpy.types, name), name
        self.texts.append(text)

    def prop(
        self, owner: bpy.types.bpy_struct, name: str, *, icon: str = "NONE", **_options: object
    ) -> None:
        """Keep the name of a property, which must exist and can be read."""
        assert icon in _ICONS, icon
        assert name in owner.bl_rna.properties, name
        getattr(owner, name)
        self.properties.append(name)

    def template_list(
        self,
        name: str,
        _list_id: str,
        owner: bpy.types.bpy_struct,
        rows_name: str,
        active_owner: bpy.types.bpy_struct,
        active_name: str,
        **_options: object,
    ) -> None:
        """Draw every item as the list would."""
        drawer = getattr(bpy.types, name)
        getattr(active_owner, active_name)
        for item in getattr(owner, rows_name):
            drawer.draw_item(None, self.context, self, owner, item, 0, active_owner, active_name)

    def operator_menu_enum(self, name: str, prop: str, **_options: object) -> None:
        """Keep the name of an operator, which must exist with an enumeration of this name."""
        self.operator_enum(name, prop)

    def operator_enum(self, name: str, prop: str) -> None:
        """Keep the name of an operator, which must exist with an enumeration of this name."""
        module, function = name.split(".")
        known = getattr(getattr(bpy.ops, module), function).get_rna_type().properties
        assert known[prop].type == "ENUM"
        self.operators.append(name)

    def operator(
        self, name: str, *, text: str = "", icon: str = "NONE", **_options: object
    ) -> SimpleNamespace:
        """Keep the name of an operator, which must exist, as must the properties set on it."""
        assert icon in _ICONS, icon
        module, function = name.split(".")
        known = getattr(getattr(bpy.ops, module), function).get_rna_type().properties
        self.operators.append(name)
        self.buttons.append(text)

        class Properties(SimpleNamespace):
            def __setattr__(self, key: str, value: object) -> None:
                assert key in known, f"{name}.{key}"

        return Properties()


def draw_panel(name: str) -> Layout:
    """Draw a panel of ours in the state that Blender is in; nothing where it would not appear."""
    layout = Layout()
    panel = getattr(bpy.types, f"CURVATURE_PT_{name}")
    context = _Context()
    if hasattr(panel, "poll") and not panel.poll(context):
        return layout
    panel.draw(SimpleNamespace(layout=layout), context)
    return layout


class _Context:
    """Blender's context with a region, which it lacks without a window."""

    region = SimpleNamespace(width=280)
    preferences = SimpleNamespace(system=SimpleNamespace(ui_scale=1.0))

    def __getattr__(self, name: str) -> object:
        return getattr(bpy.context, name)
