# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests in a real, windowed Blender on a virtual screen.

`chroot` prepares a Debian with Blender in the cache folder, `inside/` is what runs there, and
tests/window holds the scenarios and judges what came out of them.
"""
