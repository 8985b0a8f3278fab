# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of scenes in space in numpy alone: perspective, light, shadows, and smoke that shades itself."""
