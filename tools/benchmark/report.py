# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables go into docs/accuracy.md, between the comments that name them."""

from __future__ import annotations

import re

from .engine import ROOT

PAGE = ROOT / "docs" / "accuracy.md"
PICTURES = ROOT / "docs" / "pictures"


def write(sections: dict[str, str]) -> None:
    """Replace what stands between `<!-- benchmark: name -->` and `<!-- end -->`.

    Raises
    ------
    SystemExit
        If the page does not have a place for a section.
    """
    text = PAGE.read_text(encoding="utf-8")
    for name, table in sections.items():
        start = f"<!-- benchmark: {name} -->"
        place = re.compile(re.escape(start) + r".*?<!-- end -->", re.DOTALL)
        if not place.search(text):
            raise SystemExit(f"{PAGE} has no place for {name}: add {start} <!-- end -->")
        text = place.sub(lambda _, s=start, t=table: f"{s}\n{t}\n<!-- end -->", text)
    PAGE.write_text(text, encoding="utf-8")
    print(f"wrote {PAGE}")
