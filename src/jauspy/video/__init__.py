"""Video of cameras: H.264 (ITU-T H.264) over RTP (RFC 3550, RFC 6184), sent, received, recorded."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Final

from jauspy.errors import ConfigError

PACKAGES: Final = {"av": "PyAV", "cv2": "OpenCV", "numpy": "NumPy"}


def need_video() -> None:
    """Raise `ConfigError` when a package of the extra `video` is not installed.

    To be called before a module that imports these packages is imported.
    """
    missing = [title for package, title in PACKAGES.items() if find_spec(package) is None]
    if missing:
        raise ConfigError(f"video needs {', '.join(missing)}: pip install 'jauspy[video]'")
