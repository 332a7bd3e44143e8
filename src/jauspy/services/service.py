"""The base of a JAUS service: a JSIDL definition named by its URN, and a Python class with its actions."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, ClassVar

from jauspy.arguments import check_number, described
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.ids import JausID

if TYPE_CHECKING:
    from jauspy.services.host import Host


def check_services(services: object) -> list[Service]:
    """Services as they were handed in; raises `TypeError` for what is none."""
    if isinstance(services, Service) or not isinstance(services, Iterable) or isinstance(services, str):
        raise TypeError(f"services are a list, as in [Battery()], not {described(services)}")
    found = list(services)
    for each in found:
        if isinstance(each, type) and issubclass(each, Service):
            raise TypeError(f"services are made from their classes: write {each.__name__}(), not {each.__name__}")
        if not isinstance(each, Service):
            raise TypeError(f"a service is made from a class that inherits from jauspy.Service, not {described(each)}")
    return found


class Service:
    """What one JAUS service does.

    A subclass names its definition: `class PrimitiveDriver(Service, urn="urn:jaus:jss:mobility:PrimitiveDriver")`.
    Every action and predicate of the JSIDL is a method with its name in snake_case (`isControllingClient` ->
    `is_controlling_client`); `Send('ReportX', ...)` calls `report_x` and sends what it returns (None: nothing).
    Methods take what they need by name: `msg` or `query` (the message that triggered), `source` (its sender),
    `code` (the literal that the JSIDL gives, as in `'CONTROL_RELEASED'`). An action that returns a message answers
    with it; one that returns `self.host.later(...)` answers when that is fulfilled. `definitions`, from `jauspy.load`,
    has the definition of a service that is not built in.
    """

    urn: ClassVar[str] = ""
    version: ClassVar[str | None] = None
    """The version of the definition; None takes what the services that inherit from it ask for, else the newest."""
    definitions: ClassVar[Registry | None] = None
    """Where the definition and its messages are, if they are not built in."""
    private: ClassVar[bool] = False
    """True when services that inherit from this one must not use its actions as theirs."""

    omits: ClassVar[frozenset[str]] = frozenset()
    """Methods for actions that are never reached, since a predicate of this class rules them out."""

    host: Host
    """The component this service runs in; set before `attached`."""

    def __init_subclass__(
        cls,
        *,
        urn: str = "",
        version: str | None = None,
        definitions: Registry | None = None,
        private: bool = False,
    ) -> None:
        super().__init_subclass__()
        if definitions is not None and not isinstance(definitions, Registry):
            raise TypeError(f"definitions are what `jauspy.load` gives, not {described(definitions)}")
        cls.urn = urn or cls.urn
        cls.version = version or cls.version
        cls.definitions = definitions or cls.definitions
        cls.private = private or cls.private

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> object:
            """What is not there: most often `host`, in `__init__`."""
            if name == "host":
                hint = "it is there from `attached()` on, so set timers up there"
                text = f"{type(self).__name__!r} object has no attribute {name!r}; {hint}"
                raise AttributeError(text, name=name, obj=self)
            return self.__getattribute__(name)  # which says why, also when a property of the user has failed

    def every(self, seconds: float, call: Callable[[], None]) -> None:
        """Call a method of this service again and again, first in so many seconds; a second `every` replaces it.

        What was missed while the program hung is left out. `self.host.cancel_timer(call)` ends it.
        """
        check_number(seconds, "the seconds of every()")
        if not 0 < seconds < math.inf:
            raise ConfigError(f"every() is given {seconds} s; it must be above 0")
        due = self.host.now + seconds

        def tick() -> None:
            nonlocal due
            due += seconds * (1 + max(0, int((self.host.now - due) / seconds)))
            self.host.set_timer(call, due, tick)
            call()

        self.host.set_timer(call, due, tick)

    def attached(self) -> None:
        """Called once, when `host` is there and before anything is received."""

    def client_lost(self, client: JausID) -> None:
        """Called when messages to a client do not arrive any more."""

    def control_lost(self) -> None:
        """Called when the controlling client lost or gave up control, or another took it. Stop what moves."""

    def leaving(self) -> None:
        """Called before the component gives up its id or is closed. End what clients know; they can still be told."""

    def joined(self) -> None:
        """Called after `leaving`, when the component has its new id, or may be opened again under the one it had."""
