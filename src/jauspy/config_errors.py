"""Explanations of configuration mistakes, one sentence each: the key, its line and value, and what is permitted."""

from __future__ import annotations

import dataclasses
import re
import typing
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Final

from pydantic import BaseModel
from pydantic_core import ErrorDetails

_NAMES_KEY: Final = re.compile(r"[\w.\[\]-]+(:| = )")
"""The beginning of an error of a table that names a key in it."""


def explain(problem: ErrorDetails, model: type[BaseModel]) -> str:
    """One problem as `gateway.rules[0].rate = -1: input should be greater than 0`."""
    where = problem["loc"]
    key = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in where).lstrip(".")
    match problem["type"]:
        case "missing":
            return f"{key}: is missing"
        case "extra_forbidden" | "unexpected_keyword_argument":
            return (
                f"{key} = {problem['input']!r}: there is no such key; known here are: {', '.join(_keys(where, model))}"
            )
        case "value_error" if not key:
            return str(problem["ctx"]["error"])
        case "value_error" if isinstance(problem["input"], Mapping) and _NAMES_KEY.match(str(problem["ctx"]["error"])):
            return f"{key}.{problem['ctx']['error']}"
        case "tuple_type" | "model_type" | "dataclass_type" | "dict_type" | "mapping_type" as kind:
            return f"{key} = {problem['input']!r}: {_form(kind, where, model)}"
        case _:
            text = problem["msg"].removeprefix("Value error, ")
            return f"{key} = {problem['input']!r}: {text[0].lower()}{text[1:]}"


def _form(kind: str, where: tuple[int | str, ...], model: type[BaseModel]) -> str:
    """The TOML notation of a list or a table."""
    name = str(where[-1])
    tables = len(where) == 1 and any(models_in(model.model_fields[name].annotation))
    if kind == "tuple_type":
        return f"write a table [[{name}]] for each" if tables else "write a list, as in [...]"
    if not isinstance(where[-1], str):
        return "write a table"
    return f"write a table, as in [{'.'.join(part for part in where if isinstance(part, str))}]"


def _keys(where: tuple[int | str, ...], model: type[BaseModel]) -> list[str]:
    """The keys of the table in which a key is unknown."""
    table: type = model
    for part in where[:-1]:
        annotation = _annotations(table).get(str(part))  # None for an index, and for a name that the user chose
        table = next(models_in(annotation), table)
    return sorted(_annotations(table))


def _annotations(table: type) -> Mapping[str, Any]:
    """The types of the keys of a table, a model or a dataclass."""
    if issubclass(table, BaseModel):
        return {name: field.annotation for name, field in table.model_fields.items()}
    hints = typing.get_type_hints(table, include_extras=True)
    return {name: hint for name, hint in hints.items() if typing.get_origin(hint) is not typing.ClassVar}


def models_in(annotation: object) -> Iterator[type]:
    """The models and dataclasses that a type holds, as `X | None` and `tuple[X, ...]` do."""
    if isinstance(annotation, type) and typing.get_origin(annotation) is None:
        if issubclass(annotation, BaseModel) or dataclasses.is_dataclass(annotation):
            yield annotation
        return
    forms = [item.form for item in getattr(annotation, "__metadata__", ()) if hasattr(item, "form")]
    if forms:  # `Written`, `FormOf`: the table has another form than the value
        yield from forms
        return
    for argument in typing.get_args(annotation):
        yield from models_in(argument)


_NAME: Final = r"""(?:[A-Za-z0-9_-]+|"[^"]*"|'[^']*')"""
_KEY: Final = re.compile(rf"\s*({_NAME}(?:\s*\.\s*{_NAME})*)\s*=")
_HEADER: Final = re.compile(rf"\s*(\[\[?)\s*({_NAME}(?:\s*\.\s*{_NAME})*)\s*\]")
_PART: Final = re.compile(_NAME)


def line_of(text: str, keys: Sequence[str | int]) -> int | None:
    """The line of a key, numbered from 1; that of the table or list which has it, or None if the file has neither.

    `keys` leads from the outermost table to the key; a list's items have numbers.
    """
    table: tuple[str | int, ...] = ()
    lists: Counter[tuple[str | int, ...]] = Counter()
    found, longest = None, 0
    for number, line in enumerate(text.splitlines(), 1):
        if header := _HEADER.match(line):
            table = _within_lists(_names(header[2]), lists)
            if header[1] == "[[":
                table = _names(header[2])
                lists[table] += 1
                table = (*table, lists[table] - 1)
            location = table
        elif key := _KEY.match(line):
            location = (*table, *_names(key[1]))
        else:
            continue
        if len(location) > longest and location == tuple(keys[: len(location)]):
            found, longest = number, len(location)
    return found


def line_prefix(text: str, keys: Sequence[str | int]) -> str:
    """`line 12: `, or nothing for a key that is not in the file, but for example in one that it extends."""
    number = line_of(text, keys)
    return "" if number is None else f"line {number}: "


def _names(text: str) -> tuple[str | int, ...]:
    return tuple(part.strip("\"'") for part in _PART.findall(text))


def _within_lists(names: tuple[str | int, ...], lists: Counter[tuple[str | int, ...]]) -> tuple[str | int, ...]:
    """The path to a table, with the number of the last item of each list in it."""
    way: tuple[str | int, ...] = ()
    for number, name in enumerate(names, 1):
        way = (*way, name)
        if count := lists[names[:number]]:
            way = (*way, count - 1)
    return way
