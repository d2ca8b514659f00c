# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of the command line, checked before any work begins."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from ..bridge.importing import ENDINGS
from ..choices import CRITERION_OF
from ..export.formats import TEXTS
from ..geometry.display.colormap import ColorMap
from ..geometry.settings import CriterionKind, Smoothing
from ..properties.items import FAMILY_ITEMS, QUANTITY_ITEMS
from ..report.files import FORMATS
from .values import angle, not_negative, positive, size, smoothing

PROGRAM = "curvature"
_PICTURE_ENDING = ".png"
_BLEND_ENDING = ".blend"
LINE_ENDINGS = (_BLEND_ENDING, *TEXTS)
"""Endings of the files that lines can be written to."""


def parse_arguments(arguments: Sequence[str]) -> argparse.Namespace:
    """Return the values of the command line's options.

    Raises
    ------
    SystemExit
        With status 2 and a line on stderr where the usage is wrong, with 0 after `--help`.
    """
    parser = _Parser(prog=f"blender --command {PROGRAM}", description=__doc__)
    parser.description = "Curvature of architectural surfaces, without a window."
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    segment = commands.add_parser(
        "segment",
        help="find flat, single-curved and double-curved areas",
        description="Find which parts of models are flat, single-curved, domes or saddles "
        "at the tolerance of the panels. One line per object goes to the standard output.",
    )
    _add_inputs(segment)
    _add_outputs(segment, (_BLEND_ENDING,))
    _add_settings(segment)
    lines = commands.add_parser(
        "lines",
        help="trace curvature lines",
        description="Cover models with evenly spaced lines along the directions of curvature, "
        "for Blender or as a drawing. One line per object goes to the standard output.",
    )
    _add_inputs(lines)
    _add_outputs(lines, LINE_ENDINGS)
    _add_line_settings(lines)
    options = parser.parse_args(arguments)
    if options.command == "lines":
        _check_endings(lines, options, LINE_ENDINGS)
    else:
        _check_endings(segment, options, (_BLEND_ENDING,))
        _check_limits(segment, options)
    return options


class _Parser(argparse.ArgumentParser):
    """Says what is wrong in one line; the usage is a `--help` away."""

    def error(self, message: str) -> None:
        self.exit(2, f"{self.prog}: {message}; see --help\n")


def _add_inputs(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "models",
        nargs="+",
        type=Path,
        metavar="MODEL",
        help=f"file to read: {' '.join(ENDINGS)}",
    )
    parser.add_argument(
        "--up",
        choices=("Y", "Z"),
        help="axis that points up in .obj, .ply and .stl files (default: Blender's for the format)",
    )
    parser.add_argument(
        "--meters-per-unit",
        type=positive,
        metavar="M",
        help="length of one unit of the models in meters (default: that of the file, or 1)",
    )


def _add_outputs(parser: argparse.ArgumentParser, endings: tuple[str, ...]) -> None:
    drawings = f", or a drawing: {' '.join(endings[1:])}" if endings[1:] else ""
    parser.add_argument(
        "--output",
        type=Path,
        metavar="OUT.blend",
        help=f"Blender file with the results{drawings}",
    )
    parser.add_argument(
        "--report", type=Path, metavar="OUT.json", help="report on all models: .html, .json or .csv"
    )
    parser.add_argument(
        "--image", type=Path, metavar="OUT.png", help="picture of the model with its legend"
    )
    parser.add_argument(
        "--image-size",
        type=size,
        default=(1600, 1000),
        metavar="WxH",
        help="size of the picture in pixels (default: 1600x1000)",
    )
    parser.add_argument("--overwrite", action="store_true", help="replace existing files")
    parser.add_argument(
        "--json", action="store_true", help="write the report to the standard output"
    )
    parser.add_argument("--quiet", action="store_true", help="no progress on the standard error")
    parser.epilog = (
        "With several models, the Blender files and pictures get the name of their model added: "
        "OUT-model.blend. Exit status: 0 all done, 1 something failed, 2 wrong usage."
    )


def _add_analysis(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--crease-angle",
        type=angle,
        default=30.0,
        metavar="DEG",
        help="fold in degrees above which an edge separates smooth areas (default: 30)",
    )
    parser.add_argument(
        "--smoothing",
        type=smoothing,
        default=(Smoothing.AUTO, 0.0),
        metavar="auto|none|M",
        help="which detail is noise: measured, none, or all below a length in meters "
        "(default: auto)",
    )
    parser.add_argument("--flip-normals", action="store_true", help="look from the other side")


def _add_line_settings(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--spacing",
        type=positive,
        default=0.0,
        metavar="M",
        help="distance between neighboring lines in meters "
        "(default: a twentieth of the model's diagonal)",
    )
    parser.add_argument(
        "--families",
        choices=[item[0] for item in FAMILY_ITEMS],
        type=str.upper,
        default="BOTH",
        help="which of the two crossing families to trace (default: BOTH)",
    )
    parser.add_argument(
        "--asymptotic",
        action="store_true",
        help="lines without normal curvature, in place of those of principal curvature",
    )
    parser.add_argument(
        "--fit",
        type=positive,
        metavar="M",
        help="fit Bézier curves to the lines, within so many meters (default: polylines)",
    )
    parser.add_argument(
        "--thickness",
        type=positive,
        default=0.0,
        metavar="M",
        help="diameter of the lines in meters (default: a share of the spacing)",
    )
    _add_analysis(parser)
    # What segmentation has beyond, at its defaults.
    parser.set_defaults(
        panel_size=0.0,
        deviation=0.0,
        criterion=CriterionKind.PANEL,
        smallest_radius=0.0,
        gaussian_limit=0.0,
        mean_limit=0.0,
        min_area=0.0,
        color_map=ColorMap.COOL_WARM.name,
        range=None,
    )


def _add_settings(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--panel-size",
        type=positive,
        default=0.0,
        metavar="M",
        help="edge length of the panels in meters (default: a twentieth of the model's diagonal)",
    )
    parser.add_argument(
        "--deviation",
        type=positive,
        default=0.0,
        metavar="M",
        help="allowed deviation in meters (default: a two-hundredth of the panel size)",
    )
    parser.add_argument(
        "--smallest-radius",
        type=positive,
        default=0.0,
        metavar="M",
        help="radius in meters from which panels count as straight, in place of --deviation",
    )
    parser.add_argument(
        "--gaussian-limit",
        type=positive,
        default=0.0,
        metavar="K",
        help="largest |K| in 1/m² of what is not double-curved; needs --mean-limit",
    )
    parser.add_argument(
        "--mean-limit",
        type=positive,
        default=0.0,
        metavar="H",
        help="largest |H| in 1/m of what is flat; needs --gaussian-limit",
    )
    parser.add_argument(
        "--min-area",
        type=not_negative,
        default=0.0,
        metavar="M2",
        help="regions below this area in m² join a neighbor (default: 0, that of a panel)",
    )
    _add_analysis(parser)
    parser.add_argument(
        "--quantity",
        choices=[item[0] for item in QUANTITY_ITEMS if item[0] != "NONE"],
        default="CLASS",
        help="what the colors of the picture and the Blender file show (default: CLASS)",
    )
    parser.add_argument(
        "--color-map",
        choices=[color_map.name for color_map in ColorMap],
        default=ColorMap.COOL_WARM.name,
        help="colors of curvatures (default: COOL_WARM)",
    )
    parser.add_argument(
        "--range",
        type=positive,
        metavar="LIMIT",
        help="curvature that gets the last color (default: 95 %% of the area lie within)",
    )


def _check_endings(
    parser: argparse.ArgumentParser, options: argparse.Namespace, outputs: tuple[str, ...]
) -> None:
    for name, path, endings in (
        ("--output", options.output, outputs),
        ("--report", options.report, FORMATS),
        ("--image", options.image, (_PICTURE_ENDING,)),
    ):
        if path is not None and path.suffix.lower() not in endings:
            parser.error(f"{name} {path}: the file name must end in {' or '.join(endings)}")


def _check_limits(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    """Refuse limits of several criteria, and half of a pair; set the criterion that is left."""
    given = [name for name in CRITERION_OF if getattr(options, name)]
    flags = {name: f"--{name.replace('_', '-')}" for name in CRITERION_OF}
    kinds = {CRITERION_OF[name]: flags[name] for name in given}
    if len(kinds) > 1:
        parser.error(f"{' and '.join(kinds.values())} are limits of different kinds: give one")
    options.criterion = next(iter(kinds), CriterionKind.PANEL)
    pair = [name for name, kind in CRITERION_OF.items() if kind is CriterionKind.RAW]
    if options.criterion is CriterionKind.RAW and set(pair) - set(given):
        parser.error(f"{' and '.join(flags[name] for name in pair)} need each other")
