"""Explanations of configuration mistakes, one sentence each: the key, its value, and what is permitted."""

from __future__ import annotations

import typing
from collections.abc import Iterator

from pydantic import BaseModel
from pydantic_core import ErrorDetails


def explain(problem: ErrorDetails, model: type[BaseModel]) -> str:
    """One problem as `gateway.rules[0].rate = -1: input should be greater than 0`."""
    where = problem["loc"]
    key = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in where).lstrip(".")
    match problem["type"]:
        case "missing":
            return f"{key}: is missing"
        case "extra_forbidden":
            return (
                f"{key} = {problem['input']!r}: there is no such key; known here are: {', '.join(_keys(where, model))}"
            )
        case "value_error" if not key:
            return str(problem["ctx"]["error"])
        case "tuple_type" | "model_type" | "dict_type" | "mapping_type" as kind:
            return f"{key} = {problem['input']!r}: {_form(kind, where, model)}"
        case _:
            text = problem["msg"].removeprefix("Value error, ")
            return f"{key} = {problem['input']!r}: {text[0].lower()}{text[1:]}"


def _form(kind: str, where: tuple[int | str, ...], model: type[BaseModel]) -> str:
    """How a list or a table is written in TOML."""
    name = str(where[-1])
    tables = len(where) == 1 and any(models_in(model.model_fields[name].annotation))
    if kind == "tuple_type":
        return f"write a table [[{name}]] for each" if tables else "write a list, as in [...]"
    return f"write a table, as in [{name}]" if isinstance(where[-1], str) else "write a table"


def _keys(where: tuple[int | str, ...], model: type[BaseModel]) -> list[str]:
    """The keys of the table in which a key is unknown."""
    for part in where[:-1]:
        if isinstance(part, str) and part in model.model_fields:  # else a name that the user chose
            model = next(models_in(model.model_fields[part].annotation))
    return sorted(model.model_fields)


def models_in(annotation: object) -> Iterator[type[BaseModel]]:
    """The models that a type holds, as `X | None` and `tuple[X, ...]` do."""
    if isinstance(annotation, type) and typing.get_origin(annotation) is None:
        if issubclass(annotation, BaseModel):
            yield annotation
        return
    for argument in typing.get_args(annotation):
        yield from models_in(argument)
