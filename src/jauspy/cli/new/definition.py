"""`jauspy new definition`: the JSIDL of a service that reports some numbers."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Final

import typer

from jauspy.cli.new import write_new
from jauspy.codec.names import attribute, class_name, snake
from jauspy.codec.registry import MessageEntry
from jauspy.messages import registry
from jauspy.schema.loader import load_own

MAX_FIELDS: Final = 16
"""As many as there are bits in the presence vector."""
URN: Final = re.compile(r"urn(:[A-Za-z0-9][\w.-]*)+:([A-Za-z]\w*)", re.ASCII)


def definition(
    *,
    urn: Annotated[str, typer.Argument(metavar="URN", help="The service's name, as in urn:example:Battery.")],
    fields: Annotated[
        list[str],
        typer.Argument(metavar="FIELD:UNITS...", help="The reported fields, as in charge:percent cycles:one."),
    ],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="Default: battery.xml, for a Battery."),
    ] = None,
    first_id: Annotated[
        str, typer.Option("--first-id", metavar="HEX", help="Id of the query; the report has the next one.")
    ] = "D001",
) -> None:
    """Write the definition (JSIDL) of a service with a query and a report of numbers.

    The numbers are 64-bit floats, each optional, so that a client can request some of them. UNITS are JSIDL's, as in
    percent, volt, ampere, meter, "meter per second", or one for none. Message ids D000 to FFFF are for users; ids
    that a public definition uses are rejected.

    Example:
      jauspy new definition urn:example:Battery charge:percent current:ampere
    """
    name = _name(urn)
    path = output or Path(f"{snake(name)}.xml")
    write_new({path: _jsidl(urn, name, first_of_two(first_id), _fields(fields))})
    _check(path)


def _name(urn: str) -> str:
    """The service's name, which is the end of its URN."""
    match = URN.fullmatch(urn)
    if match is None:
        raise typer.BadParameter(
            f"{urn!r} is not the URN of a service: urn:, an organisation, and a name that begins with a letter, "
            "as in urn:example:Battery",
            param_hint="URN",
        )
    if any(each.service == urn for each in registry.entries):
        raise typer.BadParameter(f"{urn} is a public service; choose another name", param_hint="URN")
    return class_name(match[2])


def _fields(texts: Sequence[str]) -> list[tuple[str, str]]:

    if len(texts) > MAX_FIELDS:
        raise typer.BadParameter(f"{len(texts)} fields; a report has up to {MAX_FIELDS}")
    found = []
    for text in texts:
        name, colon, units = text.partition(":")
        if not colon or not name.isidentifier() or not name[0].isalpha() or not units.replace(" ", "").isalpha():
            raise typer.BadParameter(f"{text!r} is not NAME:UNITS, as in charge:percent")
        found.append((_jaus_name(name), units))
    if len({attribute(name) for name, _ in found}) != len(found):
        raise typer.BadParameter("two fields have the same name")
    return found


def _jaus_name(name: str) -> str:
    """`FlowRate` for `flow_rate`, and `V_2` for `v_2`, which Python would name `v2`."""
    words = [part[:1].upper() + part[1:] for part in name.split("_")]
    return "".join(words) if snake("".join(words)) == name else "_".join(words)


def _check(path: Path) -> None:
    """Read the written file, which raises an error if it is invalid."""
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


USER_IDS: Final = range(0xD000, 0xFFFF)
"""Message ids for users (AS5684); some public definitions use ids of this range, too."""


def first_of_two(text: str) -> int:
    """The message id `text`, in hexadecimal digits; it and the next one must be free."""
    try:
        code = int(text, 16)
    except ValueError:
        code = 0
    if not 0 < code < USER_IDS.stop:
        raise typer.BadParameter(f"{text!r} is not a message id; use D000 to FFFE", param_hint="--first-id")
    if (user := _user(code) or _user(code + 1)) is not None:
        raise typer.BadParameter(
            f"{user.code:04X} is {user.name} of {user.service}; {_free_from(code)}", param_hint="--first-id"
        )
    return code


def _user(code: int) -> MessageEntry | None:

    return next(iter(registry.entries_of(code)), None)


def _free_from(code: int) -> str:
    """The next free ids, at least two; those from D000 if there are no higher ones."""
    free = [each for each in USER_IDS if not _user(each)]
    pairs = [each for each in free if not _user(each + 1)]
    first = next((each for each in pairs if each > code), pairs[0])
    last = next(each for each in free if each >= first and each + 1 not in free)
    return f"{first:04X} to {last:04X} are free"
