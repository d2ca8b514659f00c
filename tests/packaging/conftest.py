# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the developers' tools importable; no other level needs them."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2]))
