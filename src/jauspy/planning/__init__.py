"""Planning: obstacles from what a robot sees, motions of arms around them, and paths over terrain."""
