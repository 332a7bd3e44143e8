"""The demo: drives to a table, finds a can with a camera, grasps and lifts it; a client like any other."""
