"""Sound of microphones and for loudspeakers: Opus (RFC 7587) or G.711 over RTP, sent, received, played, synthesised."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Final

from jauspy.errors import ConfigError

PACKAGES: Final = {"av": "PyAV", "numpy": "NumPy"}


def need_audio() -> None:
    """Raise `ConfigError` when a package that sound needs, of the extra `video`, is not installed.

    To be called before a module that imports these packages is imported.
    """
    missing = [title for package, title in PACKAGES.items() if find_spec(package) is None]
    if missing:
        raise ConfigError(f"sound needs {', '.join(missing)}: pip install 'jauspy[video]'")
