# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The composites by name: those that the segmentation was developed on, and those held out.

The later ones were made when its constants were set; how seeds are cut was improved on them.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from composites.boxes import rounded_box
from composites.composite import Composite, Recipe
from composites.profiles import (
    basket_arch,
    bottle,
    folded_plate,
    ogee,
    shoulder,
    silo,
    tulip,
    two_fillets,
)
from composites.tubes import pipe_elbow
from composites.vaults import apse_vault

Maker = Callable[[Recipe], Composite]

COMPOSITES: dict[str, Maker] = {
    "rounded box": rounded_box,
    "apse vault": apse_vault,
    "pipe elbow": pipe_elbow,
    "silo": silo,
    "folded plate": folded_plate,
}
HELD_OUT: dict[str, Maker] = {
    "round box": partial(rounded_box, half=(0.5, 0.5, 0.5), radius=0.6),
    "wide elbow": partial(pipe_elbow, bend=2.0, pipe=0.5, arm=1.5),
    "long vault": partial(apse_vault, radius=0.8, half=2.5),
    "two fillets": two_fillets,
    "tulip": tulip,
}
LATER: dict[str, Maker] = {
    "bottle": bottle,
    "basket arch": basket_arch,
    "ogee": ogee,
    "shoulder": shoulder,
}
