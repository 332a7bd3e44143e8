"""JSIDL (SAE AS5684): XML to an immutable model."""
