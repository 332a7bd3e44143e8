"""The base of services that carry out the elements of a component's list."""

from __future__ import annotations

from typing import Any, ClassVar

from jauspy.codec.message import Message
from jauspy.errors import ConfigError, DecodeError
from jauspy.services.core.list_manager import ListManager
from jauspy.services.service import Service


class ListDriver(Service):
    """Carries out elements one by one; the component's `ListManager` keeps them and knows which one is active.

    A subclass says which messages its elements hold (`element_types`), starts one in `begin_element`, calls
    `self.elements.done()` when it has been reached, and stops in `end_elements`. Of several drivers in a component
    the first that takes an element carries it out.
    """

    element_types: ClassVar[tuple[type[Message], ...]] = ()

    elements: ListManager
    """The list manager of the component; there since `attached`."""

    def attached(self) -> None:
        """Offer this driver to the list manager."""
        found = self.host.service(ListManager)
        if found is None:
            raise ConfigError(f"{type(self).__name__} carries out a list, and its definition inherits no ListManager")
        self.elements = found
        found.add_driver(self)

    # --- to be overridden

    def begin_element(self, uid: int, message: Message) -> None:
        """Go for this element; it replaces the one before, of this driver or of another one."""
        raise NotImplementedError(f"{type(self).__name__}.begin_element")

    def end_elements(self) -> None:
        """There is nothing to carry out any more: the list has come to its end, was stopped, or is another driver's."""

    def read_element(self, content: Message | bytes) -> Message | None:
        """What an element holds as one of `element_types`, None when this driver cannot carry it out."""
        data = content.encode(strict=False) if isinstance(content, Message) else content
        code = int.from_bytes(data[:2], "little")
        for kind in self.element_types:
            if code == kind.CODE:
                try:
                    return kind.decode(data)
                except DecodeError:
                    return None
        return None

    # --- given

    def element_specified(self, msg: Any) -> bool:
        """The request to execute the list names an element (else it changes the speed)."""
        return msg.element_uid is not None
