"""JSIDL (SAE AS5684): XML to an immutable model."""

from jauspy.schema.loader import builtin_paths, load_builtin, load_files
from jauspy.schema.model import Schema

__all__ = ["Schema", "builtin_paths", "load_builtin", "load_files"]
