"""`jauspy dissector`: write a dissector of JAUS for Wireshark and tshark."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated

import typer

from jauspy.cli import console
from jauspy.cli.definitions import SchemasOption, ServiceName, ServiceVersion, definitions
from jauspy.errors import ConfigError
from jauspy.inspection.dissector import make_dissector
from jauspy.printable import printable


def dissector(
    *,
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="FILE", help="The Lua file; an existing one is overwritten.")
    ] = Path("jaus.lua"),
    schemas: SchemasOption = None,
    service: ServiceName = None,
    version: ServiceVersion = None,
    message: Annotated[
        str | None,
        typer.Option("--message", metavar="NAME", help="Which message, if a service has several with one id."),
    ] = None,
) -> None:
    """Write a dissector for Wireshark and tshark: a Lua file with all messages.

    Put it into the folder of personal Lua plugins of Wireshark (Help, About Wireshark, Folders). JAUS on UDP and TCP
    port 3794 is then shown with all fields, and filtered by their names, as in
    jaus.core.request_control.authority_code > 100.

    A message id is read by the newest version of its service, as in `jauspy decode`; --service, --version and --message
    select another one.

    Examples:
      jauspy dissector -o ~/.local/lib/wireshark/plugins/jaus.lua
      jauspy dissector --schemas vendor/ -o jaus.lua
      tshark -X lua_script:jaus.lua -r run.pcapng -Y 'jaus.message == "Event"'
    """
    known = definitions(schemas)
    made = make_dissector(known.registry, known.hints(service, version, message))
    try:
        output.write_text(made.text, encoding="utf-8", newline="\n")
    except OSError as error:
        raise ConfigError(f"{printable(str(output))} cannot be written: {os.strerror(error.errno or 0)}") from None
    console.print_lines(f"{output}: {made.messages} messages, {made.fields} fields")
