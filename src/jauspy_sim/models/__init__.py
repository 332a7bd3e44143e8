"""Models for MuJoCo from the descriptions of robots: URDF, meshes, shapes, what they look like."""
