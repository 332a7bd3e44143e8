"""Fields of lengths and angles: values in SI units, shown in those of the page."""

from __future__ import annotations

import math

import pytest

pytest.importorskip("nicegui", reason="needs the extra 'console'")

from nicegui import Client
from nicegui.page import page as make_page

from jauspy.console.conventions import Conventions
from jauspy.console.panels.quantity_field import QuantityField


def test_a_speed_is_entered_in_the_unit_of_the_page_and_kept_exactly() -> None:
    conventions, changes = Conventions(), list[float | None]()
    with Client(make_page(""), request=None):
        field = QuantityField(
            conventions,
            "length",
            "{}/s".format,
            0.1,
            5.0,
            value=0.5,
            on_change=lambda: changes.append(field.value),
        )
        assert (field.element.label, field.element.value, field.element.max) == ("m/s", 0.5, 5.0)
        conventions.set({"length": "ft"})
        assert (field.element.label, field.element.value) == ("ft/s", 1.64)
        assert (field.element.min, field.element.max) == (0.33, 16.4), "nothing beyond the bounds"
        assert (field.value, changes) == (0.5, []), "another unit is no other value"
        field.element.set_value(2.0)
        assert changes == [pytest.approx(0.6096)]
        field.element.set_value(None)
        assert field.value is None


def test_a_bound_is_met_exactly() -> None:
    with Client(make_page(""), request=None):
        field = QuantityField(Conventions(), "angle", str, -math.pi, math.pi)
        field.element.set_value(180.0)
        assert field.value == math.pi
