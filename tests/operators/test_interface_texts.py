# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every text that users read follows Blender's rules, as Blender knows it."""

from __future__ import annotations

from collections.abc import Iterator

import bpy
import pytest

# Words of labels that Blender's own interface writes small, and units.
_SMALL = {"a", "an", "and", "as", "at", "by", "for", "from", "in", "of", "on", "or", "the", "to"}
_UNITS = {"(m)", "(m²)", "1/m"}
_LONGEST = 160
_BRITISH = ("colour", "metre", "grey", "centre", "neighbour", "analyse", "ise ", "behaviour")


def _classes() -> list[type]:
    operators = [getattr(bpy.types, f"CURVATURE_OT_{name}") for name in dir(bpy.ops.curvature)]
    panels = [
        getattr(bpy.types, name) for name in dir(bpy.types) if name.startswith("CURVATURE_PT_")
    ]
    return [*operators, *panels, bpy.types.CURVATURE_MT_presets]


def _properties() -> Iterator[tuple[str, bpy.types.Property]]:
    """Give every property of our operators and groups, also of groups within groups."""
    owners = [cls.bl_rna for cls in _classes() if "_OT_" in cls.__name__]
    owners += [
        getattr(bpy.types, owner).bl_rna.properties["curvature"].fixed_type
        for owner in ("Scene", "Mesh", "Object")
    ]
    inherited = {
        *bpy.types.Operator.bl_rna.properties.keys(),
        *bpy.types.PropertyGroup.bl_rna.properties.keys(),
    }
    while owners:
        rna = owners.pop()
        for key, value in rna.properties.items():
            if key in inherited:
                continue
            yield f"{rna.identifier}.{key}", value
            if value.type == "COLLECTION":
                owners.append(value.fixed_type)


def _labels() -> dict[str, str]:
    found = {cls.__name__: cls.bl_label for cls in _classes() if hasattr(cls, "bl_label")}
    found |= {name: value.name for name, value in _properties()}
    for name, value in _properties():
        for item in getattr(value, "enum_items", ()):
            found[f"{name}.{item.identifier}"] = item.name
    return found


def _tooltips() -> dict[str, str]:
    found = {cls.__name__: cls.bl_description for cls in _classes() if "_OT_" in cls.__name__}
    found |= {name: value.description for name, value in _properties()}
    for name, value in _properties():
        for item in getattr(value, "enum_items", ()):
            found[f"{name}.{item.identifier}"] = item.description
    return found


def test_there_are_texts_to_check() -> None:
    assert len(_labels()) > 60
    assert len(_tooltips()) > 60


def test_labels_are_in_title_case() -> None:
    wrong = {
        name: label
        for name, label in _labels().items()
        if not label
        or not all(
            word[0].isupper() or word[0].isdigit() or word in _SMALL | _UNITS
            for part in label.split()
            for word in [part.rstrip(",")]
        )
        or label.split()[0] in _SMALL
    }
    assert not wrong


def test_tooltips_are_sentences_without_a_full_stop() -> None:
    wrong = {
        name: text
        for name, text in _tooltips().items()
        if not text
        or not text[0].isupper()
        or text.rstrip() != text
        or text.endswith((".", "!", "?"))
        or "\n" in text
        or ". " in text
        or not 8 <= len(text) <= _LONGEST
    }
    assert not wrong


def test_tooltips_say_more_than_labels() -> None:
    labels = _labels()
    assert not [n for n, text in _tooltips().items() if text.lower() == labels.get(n, "").lower()]


@pytest.mark.parametrize("word", _BRITISH)
def test_texts_are_in_american_english(word: str) -> None:
    texts = {**_labels(), **{f"{n} tooltip": text for n, text in _tooltips().items()}}
    wrong = {n: text for n, text in texts.items() if word in f"{text.lower()} "}
    if word == "ise ":
        wrong = {n: t for n, t in wrong.items() if "noise " not in f"{t.lower()} "}
    assert not wrong


def test_lengths_and_angles_have_units() -> None:
    for name, value in _properties():
        if "angle" in name.rsplit(".", 1)[1] and value.type == "FLOAT":
            assert value.subtype == "ANGLE", name
        if name.rsplit(".", 1)[1].endswith("_shown"):
            assert value.unit in {"LENGTH", "AREA"}, name


def test_numbers_that_cannot_be_negative_are_bounded() -> None:
    for name, value in _properties():
        key = name.rsplit(".", 1)[1]
        bounded = {
            *("panel_size", "deviation", "min_area", "crease_angle", "range_limit"),
            *("smallest_radius", "gaussian_limit", "mean_limit"),
        }
        if key in bounded and "PG_results" not in name:
            assert value.hard_min >= 0.0, name
