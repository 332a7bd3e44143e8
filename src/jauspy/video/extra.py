"""The packages of the extra `video`: looked for before a module that imports them is imported itself."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Final

from jauspy.errors import ConfigError

PACKAGES: Final = {"av": "PyAV", "cv2": "OpenCV", "numpy": "NumPy"}


def need_video() -> None:
    """`ConfigError` when a package that video needs is not installed."""
    missing = [title for package, title in PACKAGES.items() if find_spec(package) is None]
    if missing:
        raise ConfigError(f"video needs {', '.join(missing)}: pip install 'jauspy[video]'")
