"""Backends are found by entry point."""

from importlib.metadata import EntryPoint

import pytest

from jauspy import backends
from jauspy.backends.kinematic import KinematicBackend
from jauspy.errors import ConfigError


def test_included_backends_are_registered() -> None:
    assert {"kinematic", "sim"} <= set(backends.names())


def test_backend_is_found_by_name() -> None:
    assert isinstance(backends.find("kinematic"), KinematicBackend)


def test_unknown_backend_error_lists_the_installed_ones() -> None:
    with pytest.raises(ConfigError, match=r"'gazebo'.*kinematic.*sim"):
        backends.find("gazebo")


@pytest.mark.parametrize("value", ["no_such_package:Backend", "jauspy.backends.kinematic:NoSuchBackend"])
def test_backend_that_cannot_be_loaded_is_a_configuration_error(monkeypatch: pytest.MonkeyPatch, value: str) -> None:
    entry = EntryPoint("broken", value, backends.GROUP)
    monkeypatch.setattr(backends, "entry_points", lambda **_: [entry])
    with pytest.raises(ConfigError, match=r"'broken'.*cannot be loaded"):
        backends.find("broken")
