"""The configuration file of a node manager: reading TOML, and writing it with all settings and their comments."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Final

from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo

from jauspy.config_errors import explain, line_prefix, models_in
from jauspy.errors import ConfigError
from jauspy.node.config import NodeConfig
from jauspy.user_files import read_toml

_WIDTH: Final = 100


def load(path: Path | None, overrides: Mapping[str, Any] | None = None) -> NodeConfig:
    """The settings of a TOML file; `overrides` that are not None, as of the command line, take precedence.

    Raises `ConfigError` that names the file, the line, the key and its permitted values.
    """
    given = {key: value for key, value in (overrides or {}).items() if value is not None}
    if path is None:
        return NodeConfig.make(**given)
    data = read_toml(path)
    try:
        return NodeConfig.model_validate(data | given)
    except ValidationError as error:
        text = path.read_text()
        problems = "".join(
            f"\n  {'' if problem['loc'][:1] and problem['loc'][0] in given else line_prefix(text, problem['loc'])}"
            f"{explain(problem, NodeConfig)}"
            for problem in error.errors(include_url=False)
        )
        raise ConfigError(f"{path}: is not a configuration of a node manager:{problems}") from None


def to_toml(config: NodeConfig) -> str:
    """All settings as a TOML file for `load`; those without a value are comments."""
    head = "# Configuration of jauspy node-manager. Omitted keys have defaults; command line options take precedence."
    return "\n".join([head, *_table(config, "")]).rstrip() + "\n"


def _table(model: BaseModel, prefix: str) -> Iterator[str]:
    """The lines of a table: its own values first, then its tables."""
    fields = type(model).model_fields
    tables = [name for name, field in fields.items() if any(models_in(field.annotation)) or _is_mapping(field)]
    for name, field in fields.items():
        if name not in tables:
            yield from ["", *_comment(field), _line(name, getattr(model, name), field)]
    for name in tables:
        yield from ["", *_comment(fields[name])]
        yield from _tables(getattr(model, name), f"{prefix}{name}", fields[name])


def _tables(value: object, name: str, field: FieldInfo) -> Iterator[str]:
    if isinstance(value, BaseModel):
        yield from [f"[{name}]", *_table(value, f"{name}.")]
    elif isinstance(value, Mapping):
        yield f"[{name}]"
        yield from (f"{json.dumps(str(key))} = {_value(each)}" for key, each in value.items())
    elif value:
        for each in value:  # type: ignore[attr-defined]  # a tuple of models
            yield from [f"[[{name}]]", *_table(each, f"{name}.")]
    else:
        for example in field.examples or ():
            lines = _tables((example,) if value == () else example, name, field)
            yield from ("#" if not line else line if line[0] == "#" else f"# {line}" for line in lines)


def _is_mapping(field: FieldInfo) -> bool:
    return getattr(field.annotation, "__origin__", None) in (dict, Mapping)


def _comment(field: FieldInfo) -> list[str]:
    text = " ".join((field.description or "").split())
    if field.is_required():
        text += " It must be given."
    elif (default := field.get_default(call_default_factory=True)) not in (None, (), {}):
        text += f" Default: {_value(default, octal=_is_octal(field))}."
    return textwrap.wrap(text, _WIDTH, initial_indent="# ", subsequent_indent="# ")


def _line(name: str, value: object, field: FieldInfo) -> str:
    if value is None:
        return f"# {name} = {_value(field.examples[0] if field.examples else '')}"
    return f"{name} = {_value(value, octal=_is_octal(field))}"


def _is_octal(field: FieldInfo) -> bool:
    extra = field.json_schema_extra
    return isinstance(extra, dict) and bool(extra.get("octal"))


def _value(value: object, *, octal: bool = False) -> str:
    """TOML of a scalar or a list."""
    match value:
        case bool():
            return str(value).lower()
        case int():
            return f"0o{value:o}" if octal else str(value)
        case float():
            return repr(value)
        case tuple() | list():
            return f"[{', '.join(_value(each) for each in value)}]"
        case _:
            return json.dumps(str(value))
