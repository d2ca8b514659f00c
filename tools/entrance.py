# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands of dev.py: what they are called, which options they take, who carries them out."""

from __future__ import annotations

import argparse
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from .blenders import BLENDERS, DEFAULT_BLENDER, PLATFORMS, SERIES
from .errors import DevError
from .interpreters import find_python
from .places import CACHE_VARIABLE, ROOT

# Imports stand in the functions below: the modules behind them need Python 3.11 for tomllib.


def main(arguments: Sequence[str]) -> int:
    """Carry out one command and return the exit status: 0 well, 1 failed, 2 wrong usage."""
    for stream in (sys.stdout, sys.stderr):
        # A pipe on Windows may not know our … and ²: better a question mark than a traceback.
        stream.reconfigure(errors="replace")  # pyright: ignore[reportAttributeAccessIssue]
    parsed = _parser().parse_args(_split_pytest(arguments)[0])
    parsed.pytest = _split_pytest(arguments)[1]
    try:
        if sys.version_info < (3, 11):
            newer = find_python("3.11")
            return subprocess.run([newer, ROOT / "dev.py", *arguments], check=False).returncode
        return parsed.run(parsed)
    except DevError as error:
        print(f"dev: error: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("dev: interrupted", file=sys.stderr)
        return 130


def _split_pytest(arguments: Sequence[str]) -> tuple[list[str], list[str]]:
    """Divide the arguments at the first `--`; what follows is pytest's."""
    words = list(arguments)
    if "--" not in words:
        return words, []
    place = words.index("--")
    return words[:place], words[place + 1 :]


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="dev.py",
        description="Build, test and try out Architectural Curvature.",
        epilog="Environments and wheels are kept in a per-user cache folder; the variable "
        f"{CACHE_VARIABLE} moves it.",
    )
    commands = parser.add_subparsers(metavar="command", required=True)

    demo = commands.add_parser("demo", help="segment the sample model with the built extension")
    demo.set_defaults(run=_demo)

    test = commands.add_parser("test", help="run the tests; arguments after -- go to pytest")
    test.add_argument("--all", action="store_true", help="in every supported Blender")
    test.add_argument(
        "--blender",
        action="append",
        choices=sorted(BLENDERS),
        metavar="VERSION",
        help=f"in this Blender, may be repeated ({', '.join(BLENDERS)}; "
        f"default {DEFAULT_BLENDER.version})",
    )
    test.add_argument(
        "--only",
        action="append",
        choices=("policy", "packaging", "geometry", "report", "blender"),
        help="only this level, may be repeated",
    )
    test.set_defaults(run=_test)

    check = commands.add_parser("check", help="check format, lint rules and types")
    check.set_defaults(run=_check)
    commands.add_parser("format", help="format the sources").set_defaults(run=_format)

    build = commands.add_parser("build", help="build the zips into dist/")
    build.add_argument(
        "--series", choices=sorted(SERIES), help="only this series of Blender versions"
    )
    build.add_argument("--platform", choices=PLATFORMS, help="only this platform")
    build.add_argument(
        "--python",
        metavar="VERSION",
        help="a zip for tests, for a Blender built with this Python (needs --blender)",
    )
    build.add_argument("--blender", metavar="VERSION", help="the Blender of --python, such as 4.3")
    build.set_defaults(run=_build)

    bench = commands.add_parser(
        "bench", help="compare with other libraries; writes docs/accuracy.md and its pictures"
    )
    bench.add_argument("what", choices=["accuracy", "speed"])
    bench.add_argument("--quick", action="store_true", help="small meshes, prints only")
    bench.add_argument(
        "--held-out", action="store_true", help="surfaces that nothing was tuned on, prints only"
    )
    bench.add_argument(
        "--largest", type=int, default=0, metavar="N", help="skip larger meshes, prints only"
    )
    bench.set_defaults(run=_bench)
    commands.add_parser("wheels", help="fetch the wheels of all platforms").set_defaults(
        run=_wheels
    )
    commands.add_parser(
        "samples", help="write the sample models of assets/models from their formulas"
    ).set_defaults(run=_samples)
    commands.add_parser(
        "presets", help="write assets/presets and docs/materials.md from their table"
    ).set_defaults(run=_presets)

    pictures = commands.add_parser(
        "pictures", help="draw models or the report of one into docs/pictures"
    )
    pictures.add_argument("kind", choices=("lines", "hatching", "report"))
    pictures.add_argument("models", nargs="*", type=Path, metavar="MODEL")
    pictures.add_argument("--spacing", type=float, metavar="M", help="between the lines")
    pictures.add_argument("--up", choices=("Y", "Z"), help="axis of the models that points up")
    pictures.set_defaults(run=_pictures)

    window = commands.add_parser(
        "window", help="test in a windowed Blender; arguments after -- go to pytest"
    )
    window.add_argument(
        "--suite",
        choices=("trixie", "sid"),
        default="trixie",
        help="the Debian suite whose Blender is used (default: trixie)",
    )
    window.set_defaults(run=_window)

    commands.add_parser(
        "lock", help="pin the newest versions anew (needs the network)"
    ).set_defaults(run=_lock)
    clean = commands.add_parser(
        "clean", help="delete dist/, out/ and the cache folder's old entries"
    )
    clean.add_argument("--cache", action="store_true", help="delete the whole cache folder")
    clean.set_defaults(run=_clean)
    return parser


def _demo(_options: argparse.Namespace) -> int:
    from . import demo

    return demo.run()


def _test(options: argparse.Namespace) -> int:
    from . import testing

    versions = list(BLENDERS) if options.all else options.blender or [DEFAULT_BLENDER.version]
    return testing.run([BLENDERS[v] for v in versions], options.only, options.pytest)


def _check(_options: argparse.Namespace) -> int:
    from . import checking

    return checking.check()


def _format(_options: argparse.Namespace) -> int:
    from . import checking

    return checking.format_sources()


def _build(options: argparse.Namespace) -> int:
    from . import build

    if bool(options.python) != bool(options.blender):
        raise DevError("--python and --blender belong together: --python 3.13 --blender 4.3")
    if options.python:
        zips = [build.build_for_tests(options.python, options.blender)]
    else:
        series = [SERIES[options.series]] if options.series else list(SERIES.values())
        platforms = [options.platform] if options.platform else list(PLATFORMS)
        zips = [path for one in series for path in build.build(one, platforms)]
    for path in zips:
        print(f"{path.relative_to(ROOT)}  {path.stat().st_size / 1e6:.1f} MB")
    return 0


def _bench(options: argparse.Namespace) -> int:
    from . import benchmarking

    return benchmarking.run(
        options.what, quick=options.quick, held_out=options.held_out, largest=options.largest
    )


def _wheels(_options: argparse.Namespace) -> int:
    from . import wheels

    for path in wheels.fetch(wheels.table()):
        print(path)
    return 0


def _pictures(options: argparse.Namespace) -> int:
    from . import pictures

    for path in pictures.write(options.kind, options.models, options.spacing, options.up):
        print(path.relative_to(ROOT))
    return 0


def _samples(_options: argparse.Namespace) -> int:
    from . import samples

    for path in samples.write(ROOT / "assets" / "models"):
        print(path.relative_to(ROOT))
    return 0


def _presets(_options: argparse.Namespace) -> int:
    from . import materials

    guide = ROOT / "docs" / "materials.md"
    guide.write_bytes(materials.guide_text().encode())
    for path in (*materials.write(ROOT / "assets"), guide):
        print(path.relative_to(ROOT))
    return 0


def _window(options: argparse.Namespace) -> int:
    from .window import run

    return run.run(options.suite, options.pytest)


def _lock(_options: argparse.Namespace) -> int:
    from . import lock, wheel_lock

    lock.write_locks()
    wheel_lock.write_table()
    return 0


def _clean(options: argparse.Namespace) -> int:
    from . import cleaning

    cleaning.clean(whole_cache=options.cache)
    return 0
