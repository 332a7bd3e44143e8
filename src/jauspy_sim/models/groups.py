"""MuJoCo's groups of geometries, which cameras draw and rays hit, or not. A world's geometries are in group 0."""

from typing import Final

VISUAL: Final = 1
"""Shapes of robots that are drawn."""

HEIGHT_FIELDS: Final = 2
"""Height fields, which collide and are drawn."""

COLLISION: Final = 3
"""Shapes that collide and are hidden: of robots, and of things in worlds that have other shapes to be seen."""

RAY_MESHES: Final = 4
"""The meshes that replace height fields in ray casts."""

SOLID: Final = 5
"""Simple shapes of the included worlds: they collide and rays hit them; meshes of the group `VISUAL` are drawn."""
