# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of curvature lines and hatching, as scenes remember and operators take them."""

from __future__ import annotations

from bpy.props import BoolProperty, EnumProperty, FloatProperty, FloatVectorProperty

from .items import FAMILY_ITEMS, LINE_KIND_ITEMS, TONE_ITEMS
from .lengths import in_scene_units


class LineProperties:
    """What a scene remembers of the last lines and hatching."""

    line_kind: EnumProperty(
        name="Kind",
        description="Which lines to trace",
        items=LINE_KIND_ITEMS,
        default="PRINCIPAL",
    )
    families: EnumProperty(
        name="Families",
        description="Which of the two crossing families of lines to trace",
        items=FAMILY_ITEMS,
        default="BOTH",
    )
    spacing: FloatProperty(
        name="Spacing (m)",
        description="Distance between neighboring lines in meters; 0 takes the panel size",
        default=0.0,
        min=0.0,
    )
    spacing_shown: FloatProperty(
        name="Spacing",
        description="Distance between neighboring lines; 0 takes the panel size",
        unit="LENGTH",
        min=0.0,
        **in_scene_units("spacing"),
    )
    thickness: FloatProperty(
        name="Thickness (m)",
        description="Diameter of the lines in meters; 0 takes a share of the spacing",
        default=0.0,
        min=0.0,
        precision=4,
    )
    thickness_shown: FloatProperty(
        name="Thickness",
        description="Diameter of the lines; 0 takes a share of the spacing",
        unit="LENGTH",
        min=0.0,
        precision=4,
        **in_scene_units("thickness"),
    )
    fit_curves: BoolProperty(
        name="Bézier Curves",
        description="Fit curves of few control points to the lines, within the tolerance",
        default=False,
    )
    fit_tolerance: FloatProperty(
        name="Tolerance (m)",
        description="Allowed distance between curve and line in meters; "
        "0 takes a five-hundredth of the spacing",
        default=0.0,
        min=0.0,
        precision=5,
    )
    fit_tolerance_shown: FloatProperty(
        name="Tolerance",
        description="Allowed distance between curve and line; "
        "0 takes a five-hundredth of the spacing",
        unit="LENGTH",
        min=0.0,
        precision=5,
        **in_scene_units("fit_tolerance"),
    )
    hatch_tone: EnumProperty(
        name="Density",
        description="Where the strokes are dense",
        items=TONE_ITEMS,
        default="SHADE",
    )
    hatch_spacing: FloatProperty(
        name="Stroke Spacing (m)",
        description="Distance between neighboring strokes where they are densest, in meters; "
        "0 takes a fraction of the model",
        default=0.0,
        min=0.0,
        precision=4,
    )
    hatch_spacing_shown: FloatProperty(
        name="Spacing",
        description="Distance between neighboring strokes where they are densest; "
        "0 takes a fraction of the model",
        unit="LENGTH",
        min=0.0,
        precision=4,
        **in_scene_units("hatch_spacing"),
    )
    hatch_light: FloatVectorProperty(
        name="Light",
        description="Direction that the light comes from",
        subtype="DIRECTION",
        default=(-0.45, -0.55, 0.7),
    )


class LineChoices:
    """What operators that trace lines can be told."""

    kind: EnumProperty(
        name="Kind",
        description="Which lines to trace",
        items=LINE_KIND_ITEMS,
        default="PRINCIPAL",
        options={"SKIP_SAVE"},
    )
    families: EnumProperty(
        name="Families",
        description="Which of the two crossing families of lines to trace",
        items=FAMILY_ITEMS,
        default="BOTH",
        options={"SKIP_SAVE"},
    )
    thickness: FloatProperty(
        name="Thickness (m)",
        description="Diameter of the lines in meters; 0 takes the scene's setting",
        default=0.0,
        min=0.0,
        precision=4,
        options={"SKIP_SAVE"},
    )
    fit_curves: BoolProperty(
        name="Bézier Curves",
        description="Fit curves of few control points to the lines, within the tolerance",
        default=False,
        options={"SKIP_SAVE"},
    )
    fit_tolerance: FloatProperty(
        name="Tolerance (m)",
        description="Allowed distance between curve and line in meters; "
        "0 takes the scene's setting",
        default=0.0,
        min=0.0,
        precision=5,
        options={"SKIP_SAVE"},
    )
    smoothing_length: FloatProperty(
        name="Smoothing Length (m)",
        description="Length in meters over which directions are averaged; "
        "0 averages as the noise of the model asks for",
        default=0.0,
        min=0.0,
        options={"SKIP_SAVE"},
    )
