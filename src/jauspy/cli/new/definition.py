"""`jauspy new definition`: the JSIDL of a service that reports some numbers."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

if TYPE_CHECKING:
    from collections.abc import Sequence

MAX_FIELDS: Final = 16
"""As many as there are bits in the presence vector."""
URN: Final = re.compile(r"urn(:[A-Za-z0-9][\w.-]*)+:([A-Za-z]\w*)", re.ASCII)


def definition(
    *,
    urn: Annotated[str, typer.Argument(metavar="URN", help="The service's name, as in urn:example:Battery.")],
    fields: Annotated[
        list[str], typer.Argument(metavar="FIELD:UNITS...", help="What it reports, as in charge:percent cycles:one.")
    ],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="Default: battery.xml, for a Battery."),
    ] = None,
    first_id: Annotated[
        str, typer.Option("--first-id", metavar="HEX", help="Id of the query; the report has the next one.")
    ] = "D001",
) -> None:
    """Write the definition (JSIDL) of a service that reports numbers: one query, one report, on request or as events.

    The numbers are 64-bit floats, each optional, so that a client asks for those it wants. UNITS are JSIDL's, as in
    percent, volt, ampere, meter, "meter per second", or one for none. D000 to FFFF are for messages of users; what a
    public definition has taken of them is refused.

    Example:
      jauspy new definition urn:example:Battery charge:percent current:ampere
    """
    from jauspy.cli.new.files import write_new
    from jauspy.cli.new.free_ids import first_of_two
    from jauspy.codec.names import snake

    name = _name(urn)
    path = output or Path(f"{snake(name)}.xml")
    write_new({path: _jsidl(urn, name, first_of_two(first_id), _fields(fields))})
    _check(path)


def _name(urn: str) -> str:
    """The service's name, which is the end of its URN."""
    from jauspy.codec.names import class_name
    from jauspy.messages import registry

    match = URN.fullmatch(urn)
    if match is None:
        raise typer.BadParameter(
            f"{urn!r} is no name of a service; use urn:, who defines it, and a name that begins with a letter, "
            "as in urn:example:Battery",
            param_hint="URN",
        )
    if any(each.service == urn for each in registry.entries):
        raise typer.BadParameter(f"{urn} is a public service; yours needs another name", param_hint="URN")
    return class_name(match[2])


def _fields(texts: Sequence[str]) -> list[tuple[str, str]]:
    from jauspy.codec.names import attribute

    if len(texts) > MAX_FIELDS:
        raise typer.BadParameter(f"{len(texts)} fields; a report has up to {MAX_FIELDS}")
    found = []
    for text in texts:
        name, colon, units = text.partition(":")
        if not colon or not name.isidentifier() or not name[0].isalpha() or not units.replace(" ", "").isalpha():
            raise typer.BadParameter(f"{text!r} is not NAME:UNITS, as in charge:percent")
        found.append((_jaus_name(name), units))
    if len({attribute(name) for name, _ in found}) != len(found):
        raise typer.BadParameter("each field needs a name of its own")
    return found


def _jaus_name(name: str) -> str:
    """`FlowRate` for `flow_rate`, and `V_2` for `v_2`, which would come back as `v2`."""
    from jauspy.codec.names import snake

    words = [part[:1].upper() + part[1:] for part in name.split("_")]
    return "".join(words) if snake("".join(words)) == name else "_".join(words)


def _check(path: Path) -> None:
    """What was written is what jauspy reads."""
    from jauspy.schema.loader import load_own

    load_own([path])


def _jsidl(urn: str, name: str, code: int, fields: Sequence[tuple[str, str]]) -> str:
    vector = "unsigned byte" if len(fields) <= 8 else "unsigned short integer"
    rows = "\n".join(
        f'            <fixed_field name="{field}" field_type="long float" field_units="{units}" optional="true"/>'
        for field, units in fields
    )
    return _TEMPLATE.format(urn=urn, name=name, query=f"{code:04X}", report=f"{code + 1:04X}", vector=vector, rows=rows)


_TEMPLATE: Final = """<?xml version="1.0" encoding="UTF-8"?>
<service_def xmlns="urn:jaus:jsidl:1.1" name="{name}" id="{urn}" version="1.0">
  <description>Reports its values on request, and as events.</description>
  <assumptions>None.</assumptions>
  <references>
    <inherits_from name="events" id="urn:jaus:jss:core:Events" version="1.1"/>
  </references>
  <declared_type_set name="Types">
    <declared_type_set_ref name="core" id="urn:jauspy:core:Types" version="1.0"/>
  </declared_type_set>
  <message_set>
    <input_set>
      <message_def name="Query{name}" message_id="{query}" is_command="false">
        <description>Asks for Report{name}; bit i of the vector asks for its i-th field.</description>
        <declared_header name="MsgHeader" declared_type_ref="core.MsgHeader"/>
        <body name="Body">
          <record name="Query{name}Rec" optional="false">
            <fixed_field name="PresenceVector" field_type="{vector}" field_units="one" optional="false"/>
          </record>
        </body>
        <footer name="Footer"/>
      </message_def>
    </input_set>
    <output_set>
      <message_def name="Report{name}" message_id="{report}" is_command="false">
        <description>The values that were asked for.</description>
        <declared_header name="MsgHeader" declared_type_ref="core.MsgHeader"/>
        <body name="Body">
          <record name="Report{name}Rec" optional="false">
            <presence_vector field_type_unsigned="{vector}"/>
{rows}
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
            <parameter type="Query{name}" value="msg"/>
            <parameter type="Receive.Body.ReceiveRec" value="transportData"/>
            <internal/>
            <action name="transport.Send">
              <argument value="'Report{name}'"/>
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
