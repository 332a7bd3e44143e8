"""Finding messages, and a user's own JSIDL in front of the built-in ones."""

from __future__ import annotations

import struct
import subprocess
import sys
import traceback
from pathlib import Path

import pytest

import jauspy
from jauspy.codec.registry import MessageEntry, Registry
from jauspy.errors import ConfigError, DecodeError, EncodeError
from jauspy.messages import core, exp, iop, mobility, registry
from jauspy.messages.core import ConfirmControl, CreateEvent, QueryTime

VENDOR = """<?xml version="1.0" encoding="UTF-8"?>
<service_def xmlns="urn:jaus:jsidl:1.1" name="Lamp" id="urn:example:vendor:Lamp" version="1.2">
  <description xml:space="preserve">A lamp.</description>
  <assumptions xml:space="preserve"/>
  <message_set>
    <input_set>
      <message_def name="SetLamp" message_id="D001" is_command="true">
        <description xml:space="preserve">Sets the brightness.</description>
        <header name="Header"><record name="HeaderRec" optional="false">
          <fixed_field name="MessageID" field_type="unsigned short integer" field_units="one" optional="false"/>
        </record></header>
        <body name="Body"><record name="LampRec" optional="false">
          <fixed_field name="Brightness" field_type="unsigned byte" field_units="percent" optional="false">
            <scale_range real_lower_limit="0.0" real_upper_limit="100.0" integer_function="round"/>
          </fixed_field>
        </record></body>
        <footer name="Footer"/>
      </message_def>
    </input_set>
    <output_set/>
  </message_set>
  <internal_events_set/>
  <protocol_behavior is_stateless="true"/>
</service_def>
"""


def test_by_name_ignores_case() -> None:
    assert registry.by_name("confirmcontrol") is ConfirmControl
    assert registry.by_name("ConfirmControl", version="1.1") is ConfirmControl
    with pytest.raises(ConfigError, match="did you mean ConfirmControl"):
        registry.by_name("ConfirmControll")
    with pytest.raises(ConfigError, match=r"no message ConfirmControl 9\.9 is known"):
        registry.by_name("ConfirmControl", version="9.9")


def test_by_code() -> None:
    codes = registry.by_code(0x000F)
    assert codes[0] is ConfirmControl
    assert {cls.SERVICE.rpartition(":")[2] for cls in codes} == {"AccessControl", "AccessControlClient"}
    assert registry.by_code(0xEEEE) == ()
    with pytest.raises(DecodeError, match="unknown message id 0x000F of urn:none"):
        registry.decode(b"\x0f\x00\x00", service="urn:none")


def test_every_message_loads() -> None:
    classes = list(registry)
    assert len(classes) == len(registry)
    assert all(
        entry.code == cls.CODE and entry.name == cls.NAME for cls, entry in zip(classes, registry.entries, strict=True)
    )


def test_newest_version_wins() -> None:
    entry = registry.entries[0]
    old = MessageEntry(entry.code, entry.name, entry.service, "0.9", "no.such.module", entry.cls)
    assert Registry([old, entry]).entries == (entry, old)
    assert Registry([old, entry]).by_name(entry.name) is entry.load()


def test_packages_list_their_messages() -> None:
    assert "SetWrenchEffort" in dir(mobility)
    assert "TimeStamp" in core.__all__
    with pytest.raises(AttributeError, match="NoSuchMessage"):
        core.NoSuchMessage  # noqa: B018


def test_dictionaries_of_nested_messages_are_converted() -> None:
    event = CreateEvent(1, 1, 0.0, QueryTime(3))
    data = event.to_dict()
    assert data["query_message"]["message"] == "QueryTime"
    assert CreateEvent.from_dict(data) == event
    with pytest.raises(EncodeError, match="did you mean 'request_id'"):
        CreateEvent.from_dict({"request_ide": 1})
    with pytest.raises(EncodeError, match="event_type: a value is required"):
        CreateEvent.from_dict({"request_id": 1})
    assert ConfirmControl.from_dict({"response_code": "NOT_AVAILABLE"}) == ConfirmControl.from_dict(
        {"response_code": 1}
    )
    with pytest.raises(EncodeError, match="response_code: 'MAYBE' is none of CONTROL_ACCEPTED"):
        ConfirmControl.from_dict({"response_code": "MAYBE"})


def test_load_own_definitions(tmp_path: Path) -> None:
    (tmp_path / "Lamp.xml").write_text(VENDOR)
    own = jauspy.load(tmp_path / "*.xml")
    lamp = own.by_name("SetLamp")
    assert lamp(50.0).encode() == b"\x01\xd0\x80"  # type: ignore[call-arg]
    assert own.decode(b"\x01\xd0\xff") == lamp(100.0)  # type: ignore[call-arg]
    assert own.by_name("ConfirmControl") is ConfirmControl
    assert len(own) == len(registry) + 1
    inside = own.by_name("CreateEvent")
    assert inside is CreateEvent
    with pytest.raises(ConfigError, match=r"no JSIDL file matches"):
        jauspy.load(tmp_path / "*.jsidl")


def test_loading_again_makes_new_classes(tmp_path: Path) -> None:
    (tmp_path / "Lamp.xml").write_text(VENDOR)
    jauspy.load(tmp_path)
    lamps = [jauspy.load(tmp_path).by_name("SetLamp") for _ in range(3)]
    assert len(set(lamps)) == 3


def test_profiles_package_exports_the_experimental_messages() -> None:
    assert iop.UpdateUGVSummary is exp.UpdateUGVSummary
    assert {"UpdateUGVSummary", "QueryUGVSummary", "ReportUGVSummary"} <= set(iop.__all__)


def test_tracebacks_show_generated_source(tmp_path: Path) -> None:
    (tmp_path / "Lamp.xml").write_text(VENDOR)
    lamp = jauspy.load(tmp_path).by_name("SetLamp")
    try:
        lamp._unpack(b"", None)
    except struct.error:
        assert ".unpack(data)" in traceback.format_exc()
    else:
        pytest.fail("an empty message was read")


def test_import_is_light() -> None:
    heavy = "[m for m in ('lxml', 'construct', 'pydantic', 'asyncio', 'rich') if m in sys.modules]"
    code = f"import sys, jauspy; print({heavy})"
    assert (
        subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout.strip() == "[]"
    )
    code = f"import sys; from jauspy.messages.core import ConfirmControl; print({heavy})"
    assert (
        subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout.strip() == "[]"
    )
