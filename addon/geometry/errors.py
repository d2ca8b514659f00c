# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What can go wrong in the geometry, each with a sentence that a user can act on."""

from __future__ import annotations


class CurvatureError(ValueError):
    """A refusal: the input cannot be analyzed; the message says why and what to do."""


class InvalidMeshError(CurvatureError):
    """The mesh is empty, has broken indices or coordinates that are not finite."""


class InvalidSettingError(CurvatureError):
    """A setting has a value that makes no sense."""
