"""The capability modules of a robot: their services, their configuration, and the robot as a whole."""
