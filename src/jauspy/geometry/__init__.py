"""Vectors, poses, frames, robot descriptions, kinematics and geodesy: pure functions without I/O."""
