"""Makes the included worlds: MJCF files, their visual meshes, and the height map of `rubble`."""
