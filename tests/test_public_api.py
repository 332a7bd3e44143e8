from __future__ import annotations

import subprocess
import sys

import pytest

import jauspy

PUBLIC = {
    "OCU",
    "CodecError",
    "Component",
    "ConfigError",
    "ControlRejected",
    "DecodeError",
    "ElementRejected",
    "EncodeError",
    "EventRejected",
    "JausError",
    "JausID",
    "Message",
    "ProtocolError",
    "Registry",
    "RequestError",
    "ResponseTimeout",
    "Robot",
    "SchemaError",
    "Service",
    "ServiceClient",
    "Subscription",
    "TransportError",
    "load",
    "run",
}


def test_public_names_are_pinned():
    assert set(jauspy._EXPORTS) == PUBLIC
    assert set(dir(jauspy)) >= PUBLIC


@pytest.mark.parametrize("name", sorted(PUBLIC))
def test_all_public_names_can_be_imported(name):
    assert getattr(jauspy, name) is getattr(sys.modules[jauspy._EXPORTS[name]], name)


def test_unknown_names_raise_attribute_error():
    with pytest.raises(AttributeError, match="no attribute 'Ocu'"):
        jauspy.Ocu  # noqa: B018


@pytest.mark.slow
def test_packages_are_imported_on_first_use():
    code = "import jauspy; print(jauspy.sync.OCU, jauspy.testing.until, jauspy.ocu.Appeared, jauspy.messages.registry)"
    subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("statement", "unwanted"),
    [
        ("import jauspy", "asyncio lxml pydantic rich typer construct yaml psutil"),
        ("import jauspy; jauspy.JausID.parse('1.2.3'); jauspy.ControlRejected", "asyncio lxml pydantic rich typer"),
        ("import jauspy; jauspy.OCU", "pydantic rich typer construct mujoco psutil"),
    ],
)
def test_unused_packages_are_not_imported(statement, unwanted):
    code = f"import sys; {statement}; print(*sys.modules)"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert not set(unwanted.split()) & set(run.stdout.split())


@pytest.mark.parametrize(
    ("statement", "most"),
    [
        ("import jauspy", 3),
        ("import jauspy.messages", 20),
        ("from jauspy.messages.mobility import SetWrenchEffort", 40),
    ],
)
def test_import_loads_few_modules(statement, most):
    """Modules, not milliseconds: of jauspy, and of all others beyond what Python itself loads."""
    code = f"import sys; before = set(sys.modules); {statement}; print(*(set(sys.modules) - before))"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = run.stdout.split()
    assert "jauspy" in loaded
    assert len([name for name in loaded if name.startswith("jauspy")]) <= most, loaded
    assert len(loaded) <= 200
    assert len([name for name in loaded if name.startswith("jauspy.messages.") and name.count(".") == 4]) <= 4, loaded
