"""A dissector for Wireshark: one Lua file, made of the layouts of messages and an engine that reads them."""

from __future__ import annotations

from importlib.resources import files
from typing import Final, NamedTuple

from jauspy.codec.registry import NO_HINTS, STANDARD, Hints, Registry
from jauspy.inspection.dissector.tables import Tables, number, quoted, source

ENGINE: Final = ("fields", "messages", "packets", "serial")
"""Lua files of the engine, in their order."""
_HEAD: Final = """\
-- JAUS for Wireshark and tshark, made by `jauspy dissector`; do not edit.
-- Put this file into the folder that Wireshark lists as "Personal Lua Plugins" (Help, About, Folders), or load it with
--   tshark -X lua_script:jaus.lua -r capture.pcapng
"""


class Dissector(NamedTuple):
    """A dissector's Lua source (UTF-8), and how many messages and fields it knows."""

    text: str
    messages: int
    fields: int


def make_dissector(registry: Registry, wanted: Hints = NO_HINTS) -> Dissector:
    """A dissector. Each message id has the meaning that `registry` decodes it with, narrowed by `wanted`."""
    tables = Tables()
    messages: list[str] = []
    ambiguous: list[str] = []
    for code in sorted({entry.code for entry in registry.entries}):
        hints = registry.narrowed(code, wanted) if wanted != NO_HINTS else NO_HINTS
        kind = registry.class_of(code.to_bytes(2, "little"), hints)
        if kind is not None:
            messages.append(f"[{number(code)}]={source(tables.message(kind))},\n")
        elif collision := registry.collision(code, hints):
            names = [f"{e.name} of {e.service.removeprefix(STANDARD)} {e.version}" for e in collision.entries]
            text = f"{' or '.join(names)}; make the dissector with --{collision.remedy} to choose"
            ambiguous.append(f"[{number(code)}]={quoted(text)},\n")
    enums = [f"{source(dict(names))},\n" for names in tables.enums]
    parts = [_table("ENUMS", enums), _table("MESSAGES", messages), _table("AMBIGUOUS", ambiguous)]
    return Dissector("\n".join([_HEAD, *parts, engine()]), len(messages), tables.fields)


def engine() -> str:
    """The part of the file that is always the same: the Lua files beside this one, which share their local names."""
    folder = files(__name__)
    return "\n".join(folder.joinpath(f"{name}.lua").read_text("utf-8") for name in ENGINE)


def _table(name: str, rows: list[str]) -> str:
    return f"local {name} = {{\n{''.join(rows)}}}\n"
