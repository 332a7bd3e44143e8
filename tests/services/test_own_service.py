"""A user's own service: JSIDL and a class, nothing else."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import jauspy
from jauspy.errors import ConfigError, SchemaError
from jauspy.messages.core import ConfirmEventRequest, CreateEvent, Event, RejectEventRequest
from jauspy.schema import builtin_paths, load_files
from jauspy.services.core import Discovery, Liveness
from jauspy.services.service import Service

JSIDL = """<?xml version="1.0" encoding="UTF-8"?>
<service_def xmlns="urn:jaus:jsidl:1.1" name="Battery" id="urn:example:Battery" version="1.0">
  <description>Tells how full the battery is.</description>
  <assumptions>None.</assumptions>
  <references>
    <inherits_from name="events" id="urn:jaus:jss:core:Events" version="1.1"/>
  </references>
  <declared_type_set name="types">
    <declared_type_set_ref name="core" id="urn:jauspy:core:Types" version="1.0"/>
  </declared_type_set>
  <message_set>
    <input_set>
      <message_def name="QueryBattery" message_id="2FF0" is_command="false">
        <description>Asks for the charge.</description>
        <declared_header name="MsgHeader" declared_type_ref="core.MsgHeader"/>
        <body name="Body">
          <record name="QueryBatteryRec" optional="false">
            <fixed_field name="PresenceVector" field_type="unsigned byte" field_units="one" optional="false"/>
          </record>
        </body>
        <footer name="Footer"/>
      </message_def>
    </input_set>
    <output_set>
      <message_def name="ReportBattery" message_id="4FF0" is_command="false">
        <description>Tells the charge.</description>
        <declared_header name="MsgHeader" declared_type_ref="core.MsgHeader"/>
        <body name="Body">
          <record name="ReportBatteryRec" optional="false">
            <presence_vector field_type_unsigned="unsigned byte"/>
            <fixed_field name="Charge" field_type="unsigned byte" field_units="percent" optional="true"/>
            <fixed_field name="Cycles" field_type="unsigned short integer" field_units="one" optional="true"/>
          </record>
        </body>
        <footer name="Footer"/>
      </message_def>
    </output_set>
  </message_set>
  <internal_events_set/>
  <protocol_behavior is_stateless="false">
    <start state_machine_name="events.transport.ReceiveFSM" state_name="Receiving.Ready"/>
    <start state_machine_name="events.transport.SendFSM" state_name="Sending"/>
    <state_machine name="events.transport.ReceiveFSM">
      <state name="Receiving" initial_state="Ready">
        <state name="Ready">
          <transition name="transport.Receive">
            <parameter type="QueryBattery" value="msg"/>
            <parameter type="Receive.Body.ReceiveRec" value="transportData"/>
            <internal/>
            <action name="transport.Send">
              <argument value="'ReportBattery'"/>
              <argument value="transportData"/>
            </action>
          </transition>
        </state>
      </state>
    </state_machine>
    <state_machine name="events.transport.SendFSM">
      <state name="Sending"/>
    </state_machine>
  </protocol_behavior>
</service_def>
"""


@pytest.fixture
def own(tmp_path: Path):
    file = tmp_path / "Battery.xml"
    file.write_text(JSIDL)
    return jauspy.load(file), load_files([file, *builtin_paths()])


@pytest.mark.slow
def test_user_defined_service_runs_and_can_be_subscribed(own, make) -> None:
    registry, schema = own
    report = registry.by_name("ReportBattery")
    query = registry.by_name("QueryBattery")

    class Battery(Service, urn="urn:example:Battery"):
        def report_battery(self):
            return report(charge=80, cycles=512)

    rig = make(Battery(), Discovery(), schema=schema, registry=registry)

    def said(message) -> bytes:
        rig.host.receive(message.encode(), rig.ID.parse("42.1.1"), rig.now)
        (outgoing,) = rig.host.poll_output(rig.now)
        return outgoing.payload

    assert report.decode(said(query(0xFF))) == report(charge=80, cycles=512)
    assert report.decode(said(query(1))) == report(charge=80)
    confirmed = said(CreateEvent(1, 0, 1.0, query(2)))
    assert confirmed[:2] == b"\xf3\x01"
    ((_, _, event),) = rig.run(0.5)
    assert isinstance(event, Event)
    content = event.report_message
    assert (content if isinstance(content, bytes) else content.encode()) == report(cycles=512).encode()


@pytest.mark.slow
@pytest.mark.parametrize("parameter", ['<parameter type="QueryBattery" value="msg"/>', ""])
def test_transition_named_after_an_input_is_on_its_receipt(tmp_path: Path, make, parameter: str) -> None:
    """As in the JAUS Toolset, also without a parameter for the message."""
    file = tmp_path / "Battery.xml"
    named = JSIDL.replace('name="transport.Receive"', 'name="QueryBattery"')
    file.write_text(named.replace('<parameter type="QueryBattery" value="msg"/>', parameter))
    registry = jauspy.load(file)
    query, report = registry.by_name("QueryBattery"), registry.by_name("ReportBattery")

    class Battery(Service, urn="urn:example:Battery"):
        def report_battery(self, query: Any) -> Any:
            assert query.presence_vector == 1
            return report(charge=80, cycles=512)

    rig = make(Battery(), schema=load_files([file, *builtin_paths()]), registry=registry)
    rig.host.receive(query(1).encode(), rig.ID.parse("42.1.1"), rig.now)
    (outgoing,) = rig.host.poll_output(rig.now)
    assert report.decode(outgoing.payload) == report(charge=80)


@pytest.mark.slow
def test_experimental_message_ids_can_be_subscribed(tmp_path: Path, make) -> None:
    """From D000h on, a code does not say what kind of message it is."""
    file = tmp_path / "Battery.xml"
    file.write_text(JSIDL.replace("2FF0", "D001").replace("4FF0", "D002"))
    registry = jauspy.load(file)
    query, report = registry.by_name("QueryBattery"), registry.by_name("ReportBattery")

    class Battery(Service, urn="urn:example:Battery"):
        def report_battery(self) -> Any:
            return report(charge=80, cycles=512)

    rig = make(Battery(), schema=load_files([file, *builtin_paths()]), registry=registry)
    assert isinstance(rig.ask("42.1.1", CreateEvent(1, 0, 1.0, query(1).encode())), ConfirmEventRequest)
    ((_, _, event),) = rig.run(0.5)
    assert event.report_message == report(charge=80).encode()
    assert isinstance(rig.ask("42.1.1", CreateEvent(1, 0, 1.0, report(charge=1).encode())), RejectEventRequest)


def test_ambiguous_id_is_rejected(tmp_path: Path, make) -> None:
    file = tmp_path / "battery.xml"
    file.write_text(JSIDL.replace("2FF0", "2202"))
    registry = jauspy.load(file)

    class Battery(Service, urn="urn:example:Battery", definitions=registry):
        def report_battery(self) -> Any:
            return None

    make(Battery())
    with pytest.raises(ConfigError, match="2202 is QueryBattery of urn:example:Battery and QueryHeartbeatPulse of urn"):
        make(Battery(), Liveness())


@pytest.mark.parametrize(
    ("right", "wrong", "problem"),
    [
        ("<internal/>", '<guard condition="a( and b"/><internal/>', r"46: guard 'a\( and b': expected"),
        ("<internal/>", '<simple><end_state state="Receiving.Reddy"/></simple>', "46: .*no state 'Reddy'.*Ready"),
        ('type="QueryBattery"', 'type="QueryBatery"', "46: .*receives 'QueryBatery'.*QueryBattery"),
        ('initial_state="Ready"', 'initial_state="Rady"', "44: .*no state 'Rady'.*Ready"),
    ],
)
def test_invalid_behaviour_is_reported_with_file_and_line(tmp_path: Path, right: str, wrong: str, problem) -> None:
    file = tmp_path / "battery.xml"
    assert JSIDL.count(right) == 1
    file.write_text(JSIDL.replace(right, wrong))

    class Battery(Service, urn="urn:example:Battery", definitions=jauspy.load(file)):
        def report_battery(self) -> Any:
            return None

    with pytest.raises(SchemaError, match=rf"battery\.xml:{problem}"):
        jauspy.Component("101.1.120", [Battery()])
