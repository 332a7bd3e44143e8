"""YAML of other people: without aliases, and not nested without end."""

from __future__ import annotations

from typing import Any

import yaml


class _Loader(yaml.SafeLoader):
    """Refuses aliases: with them, a small file has texts of gigabytes."""

    def compose_node(self, parent: yaml.Node | None, index: Any) -> yaml.Node | None:
        if self.check_event(yaml.AliasEvent):
            raise yaml.YAMLError("write out what the alias stands for; aliases are not read")
        return super().compose_node(parent, index)


def parse_yaml(data: bytes | str) -> Any:
    """The value of a YAML document, of plain types; raises `yaml.YAMLError`."""
    try:
        return yaml.load(data, _Loader)  # noqa: S506 # nosec B506 # a safe loader
    except RecursionError:
        raise yaml.YAMLError("it is nested too deeply") from None
    except (ValueError, OverflowError) as error:  # dates, and numbers with thousands of digits
        raise yaml.YAMLError(str(error)) from None
