"""The board on which orders are announced and submitted: all that a task is told beside what components report."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from jauspy.errors import ConfigError


@dataclass(slots=True)
class OpenOrder:
    """An order that was announced, with the products that it wants now, by quadrant."""

    id: str
    tray: int
    products: Mapping[int, str]
    """Types by quadrant of the tray."""
    priority: bool
    announced: float
    """Seconds from the start of the trial."""
    changed: float | None = None
    """When its products were changed last."""
    submitted: float | None = None

    @property
    def duration(self) -> float:
        """Seconds from the announcement to the submission; NaN before."""
        return float("nan") if self.submitted is None else self.submitted - self.announced


class OrderBoard:
    """Orders by id, in the order of their announcement; `clock` gives seconds from the start of the trial."""

    def __init__(self, clock: Callable[[], float], on_submit: Callable[[OpenOrder], None] = lambda _: None) -> None:
        self._clock = clock
        self._on_submit = on_submit
        self.orders: dict[str, OpenOrder] = {}
        self.is_complete = False
        """True when no further order will be announced."""

    def announce(self, id: str, tray: int, products: Mapping[int, str], *, priority: bool) -> None:
        """Announce an order."""
        self.orders[id] = OpenOrder(id, tray, dict(products), priority, self._clock())

    def change(self, id: str, products: Mapping[int, str]) -> bool:
        """Change what an order wants; false if it is not open."""
        order = self.orders.get(id)
        if order is None or order.submitted is not None:
            return False
        order.products, order.changed = dict(products), self._clock()
        return True

    def submit(self, id: str) -> None:
        """Submit an order: its tray is scored as it is now, and taken away. Raises `ConfigError` if it is not open."""
        order = self.orders.get(id)
        if order is None or order.submitted is not None:
            raise ConfigError(f"the order {id!r} is not open")
        order.submitted = self._clock()
        self._on_submit(order)

    def most_urgent(self) -> OpenOrder | None:
        """The open order to work on: those with priority first, then the first that was announced."""
        waiting = [order for order in self.orders.values() if order.submitted is None]
        return min(waiting, key=lambda order: not order.priority, default=None)

    @property
    def is_done(self) -> bool:
        """True when all orders are submitted, and no further one will come."""
        return self.is_complete and all(order.submitted is not None for order in self.orders.values())
