# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of the benchmarks."""

from __future__ import annotations

import argparse
import os

# One thread for the linear algebra of all: ours uses threads of its own.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


def main() -> int:
    """Run one benchmark and write its tables and plots to docs/."""
    parser = argparse.ArgumentParser(prog="dev.py bench", description=__doc__)
    parser.add_argument("what", choices=["accuracy", "speed"])
    parser.add_argument("--quick", action="store_true", help="small meshes, prints only")
    parser.add_argument("--held-out", action="store_true", help="other surfaces, prints only")
    parser.add_argument("--largest", type=int, default=0, help="skip larger meshes, prints only")
    options = parser.parse_args()
    if options.what == "accuracy":
        from . import accuracy

        accuracy.run(quick=options.quick, held_out=options.held_out, largest=options.largest)
    else:
        from . import speed

        speed.run(quick=options.quick, largest=options.largest)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
