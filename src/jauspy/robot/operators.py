"""The operators file of a robot: who may command, with which key and role. See docs/security.md."""

from __future__ import annotations

import secrets
import stat
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Annotated

from pydantic import Field, ValidationError

from jauspy.config_errors import explain
from jauspy.errors import ConfigError
from jauspy.platform.tables import Name
from jauspy.protocol.seal import DEFAULT_ROLES, Operator, PublicKey
from jauspy.robot.config import RobotConfig, StrictConfig
from jauspy.services.core import CommandSeal
from jauspy.services.core.command_seal import CommandRecord
from jauspy.user_files import read_toml


class _OperatorConfig(StrictConfig):
    role: Name
    key: str


class _OperatorsConfig(StrictConfig):
    roles: Mapping[Name, Annotated[int, Field(ge=0, le=255)]] = {}
    operators: Mapping[Name, _OperatorConfig]


def load(path: str | Path) -> list[Operator]:
    """The operators of a file; raises `ConfigError` that names the mistake."""
    path = Path(path)
    try:
        if path.stat().st_mode & stat.S_IWOTH:
            raise ConfigError(f"{path}: all users may change it; do: chmod o-w {path}")
        config = _OperatorsConfig.model_validate(read_toml(path))
    except OSError as error:
        raise ConfigError(f"operators: {path}: cannot be read: {error.strerror}") from error
    except ValidationError as error:
        problems = "\n".join(f"  {explain(problem, _OperatorsConfig)}" for problem in error.errors(include_url=False))
        raise ConfigError(f"{path}: is not a file of operators:\n{problems}") from error
    roles = {**DEFAULT_ROLES, **config.roles}
    found: dict[int, Operator] = {}
    for name, operator in config.operators.items():
        if operator.role not in roles:
            raise ConfigError(f"{path}: operators.{name}.role = {operator.role!r}; the roles are: {', '.join(roles)}")
        try:
            key = PublicKey.parse(operator.key)
        except ConfigError as error:
            raise ConfigError(f"{path}: operators.{name}.key: {error}") from error
        if key.id in found:
            raise ConfigError(
                f"{path}: operators.{name}.key: is also that of {found[key.id].name}; give each operator another key"
            )
        found[key.id] = Operator(name, operator.role, roles[operator.role], key)
    return list(found.values())


def command_seals(
    config: RobotConfig, audit: Callable[[CommandRecord], None] | None
) -> Callable[[], tuple[CommandSeal, ...]]:
    """Makes the CommandSeal of each component of a robot; none without an operators file."""
    if config.operators is None:
        return tuple
    operators = load(config.operators)
    return lambda: (
        CommandSeal(operators, secret=secrets.token_bytes(32), required=config.require_operator, audit=audit),
    )
