# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Architectural Curvature: where Blender enters and leaves the extension.

Nothing is imported at module level, so that `addon.geometry` works and is tested without Blender.
"""


def register() -> None:
    """Register the extension with Blender."""
    from .addon import registration

    registration.register()


def unregister() -> None:
    """Undo `register`."""
    from .addon import registration

    registration.unregister()
