#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The developers' single entrance: `python3 dev.py --help`. The work is done in tools/."""

import sys

if sys.version_info < (3, 9):
    sys.exit("dev.py needs Python 3.9 or newer; this is " + sys.version.split()[0])

from tools.entrance import main

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
