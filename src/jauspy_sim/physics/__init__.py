"""Parts of the simulated robot: joints, tracks, wheels and sensors."""
