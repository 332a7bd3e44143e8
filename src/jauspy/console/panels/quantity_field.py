"""A field of a length, speed or angle in the unit that the page shows; its value is in metres, m/s or radians."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Final

from nicegui import ui

from jauspy.console.conventions import Conventions

DIGITS: Final = 2
"""Behind the point, of what is shown."""


class QuantityField:
    """A field of a `kind` of `Conventions.unit`; `label` makes its label of the unit.

    `least`, `most` and `value` are in SI units; `step` is in the unit that is shown. `on_change` is called when the
    operator has changed the value, not when the unit changes.
    """

    def __init__(
        self,
        conventions: Conventions,
        kind: str,
        label: Callable[[str], str],
        least: float,
        most: float,
        *,
        value: float | None = None,
        step: float | None = None,
        on_change: Callable[[], Any] | None = None,
    ) -> None:
        self._conventions, self._kind, self._label = conventions, kind, label
        self._least, self._most, self._value = least, most, value
        self._on_change = on_change
        self._is_shown = False
        """True while the unit or the value is set here."""
        self.element = ui.number(label(""), step=step, on_change=self._changed).props("dense outlined")
        self._show()
        conventions.on_change.append(self._show)

    @property
    def value(self) -> float | None:
        """The value in SI units, as it was set or entered; None for an empty field."""
        return self._value

    def set_value(self, value: float | None) -> None:
        """Show a value of SI units."""
        self._value = value
        self._show()

    def _changed(self) -> Any:
        if self._is_shown:
            return None
        shown = self.element.value
        self._value = None if shown is None else self._in_si(float(shown))
        return None if self._on_change is None else self._on_change()

    def _in_si(self, shown: float) -> float:
        value = shown / self._conventions.factor(self._kind)
        for bound in (self._least, self._most):
            if math.isclose(value, bound):
                return bound
        return value

    def _show(self) -> None:
        factor = self._conventions.factor(self._kind)
        self._is_shown = True
        try:
            self.element.label = self._label(self._conventions.unit(self._kind))
            self.element.min = _rounded(self._least * factor, math.ceil)
            self.element.max = _rounded(self._most * factor, math.floor)
            self.element.set_value(None if self._value is None else round(self._value * factor, DIGITS))
        finally:
            self._is_shown = False


def _rounded(value: float, whole: Callable[[float], int]) -> float:
    """The nearest number with `DIGITS` that is not beyond a bound."""
    return whole(round(value * 10.0**DIGITS, 6)) / 10.0**DIGITS
