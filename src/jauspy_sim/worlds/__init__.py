"""Worlds: the included ones, and those from files in MJCF, SDF and lists of objects."""
