# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the extension is made of; imports nothing, so that `geometry` loads without Blender."""
