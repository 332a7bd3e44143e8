"""What a robot's TOML file may say."""

from __future__ import annotations

from collections import Counter
from typing import Annotated, Literal, Self, TypeAlias

from pydantic import BaseModel, ConfigDict, Field, model_validator

from jauspy.ids import JausID

Name: TypeAlias = Annotated[str, Field(min_length=1, max_length=64)]
Service: TypeAlias = Literal[
    "Time", "Liveness", "Discovery", "PrimitiveDriver", "VelocityStateSensor", "LocalPoseSensor"
]


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class AccessControlConfig(_Strict):
    """Who may control a module, and how long a client may be silent."""

    timeout: Annotated[int, Field(ge=0, le=255)] = 5
    """Seconds, 1..255; 0 never takes control back."""
    default_authority: Annotated[int, Field(ge=0, le=255)] = 1
    """What a client needs at least."""


class ModuleConfig(_Strict):
    """One capability module: a JAUS component."""

    type: Literal["CM-MOB"]
    component: Annotated[int, Field(ge=1, le=254)]
    services: tuple[Service, ...] | None = None
    """Beside Transport, Events, AccessControl and Management; all that the type offers when left out."""
    access_control: AccessControlConfig = AccessControlConfig()


class RobotConfig(_Strict):
    """One robot: a JAUS node with its capability modules, on a backend."""

    name: Name
    description: Annotated[str, Field(max_length=200)] = ""
    model: Name
    """The backend's name of the robot."""
    subsystem: Annotated[int, Field(ge=1, le=65534)]
    node: Annotated[int, Field(ge=1, le=254)]
    backend: Name = "kinematic"
    world: Name = "empty"
    modules: tuple[ModuleConfig, ...]

    @model_validator(mode="after")
    def _check_modules(self) -> Self:
        if not self.modules:
            raise ValueError("modules: there is none; a robot needs one or more [[modules]]")
        for component, count in Counter(module.component for module in self.modules).items():
            if count > 1:
                raise ValueError(f"modules: {count} have the component id {component}; give each its own, 1..254")
        return self

    def id_of(self, module: ModuleConfig) -> JausID:
        """The JAUS id of a module."""
        return JausID(self.subsystem, self.node, module.component)
