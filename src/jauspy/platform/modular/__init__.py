"""Modular robots: servo modules, vacuum connectors, and the arms and vehicles that are assembled from them.

Their control needs the extra `cell`, whose libraries may be missing, or miss a library of the system.
"""

from __future__ import annotations

from importlib import import_module

from jauspy.errors import ConfigError


def check_libraries(user: str, *libraries: str, extra: str = "cell") -> None:
    """Import `libraries`; raises `ConfigError` that says what `user` needs, and which extra installs it."""
    for library in libraries:
        try:
            import_module(library)
        except ModuleNotFoundError as error:
            raise ConfigError(f"{user} needs {error.name}: pip install 'jauspy[{extra}]'") from error
        except ImportError as error:  # the wheel of pinocchio does not contain libgomp, which bare machines do not have
            hint = "; on Debian and Ubuntu: apt-get install libgomp1" if "libgomp" in str(error) else ""
            raise ConfigError(f"{user} cannot load {library}: {error}{hint}") from error
