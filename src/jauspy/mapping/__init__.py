"""Maps out of range scans while driving: an occupancy grid, scan matching, and files as map_server has them.

Needs the extra `map` (numpy).
"""
