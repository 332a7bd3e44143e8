"""What the tracked robots inc1 and inc1_pprm look like, part by part; `tools/make_robot_meshes.py` writes it."""
