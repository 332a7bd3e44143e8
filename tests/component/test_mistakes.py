"""What an author of components may hand in wrongly: one sentence that says what, and what to do."""

from __future__ import annotations

import pytest

import jauspy
from jauspy.services.core import AccessControl, Events, Liveness


class Early(jauspy.Service, urn="urn:example:Early"):
    def __init__(self) -> None:
        self.every(1.0, self.attached)


class Misspelt(jauspy.Service, urn="urn:jaus:jss:mobility:PrimitveDriver"):
    pass


class Unknown(jauspy.Service, urn="urn:example:Unknown"):
    pass


OF_A_WRONG_TYPE = {
    "class": (
        lambda: jauspy.Component("1.1.1", [Liveness]),
        r"^services are made.* write Liveness\(\), not Liveness$",
    ),
    "bare": (
        lambda: jauspy.Component("1.1.1", Liveness()),
        r"^services are a list, as in \[Battery\(\)\], not the",
    ),
    "nothing": (lambda: jauspy.Component("1.1.1", None), r"^services are a list.*not None$"),
    "text": (lambda: jauspy.Component("1.1.1", ["Liveness"]), r"inherits from jauspy.Service, not the str 'Liveness'$"),
    "id": (lambda: jauspy.Component(1, []), r"^a JAUS id is text, as in '101\.1\.102', or a JausID, not the int 1$"),
    "name": (lambda: jauspy.Component("1.1.1", [], name=5), r"^a component's name is text, not the int 5$"),
    "definitions": (
        lambda: type("Lamp", (jauspy.Service,), {}, urn="urn:example:Lamp", definitions="lamp.xml"),
        r"^definitions must be a result of `jauspy.load`, not the str 'lamp.xml'$",
    ),
    "run": (lambda: jauspy.run(Liveness()), r"^run\(\) takes components, as in jauspy\.Component\("),
    "seconds": (lambda: AccessControl(timeout=2.5), r"^access control: timeout is a whole number, not the float 2\.5$"),
    "minutes": (lambda: Events(timeout=1.5), r"^events: timeout is a whole number"),
    "limit": (lambda: Events(limit_per_client="8"), r"^events: limit_per_client is a whole number, not the str '8'$"),
    "rate": (lambda: Events(max_rate="50"), r"^events: max_rate is a number, not the str '50'$"),
}


@pytest.mark.parametrize(("make", "words"), OF_A_WRONG_TYPE.values(), ids=OF_A_WRONG_TYPE)
def test_wrong_types_raise_named_errors(make, words):
    with pytest.raises(TypeError, match=words):
        make()


OUT_OF_RANGE = {
    "bug": (
        lambda: jauspy.Component("1.1.1", [], on_action_error="stop"),
        r"it must be .stay. or .failure.$",
    ),
    "limit": (lambda: Events(limit=257), r"^events: limit is 257; it must be 0\.\.256$"),
    "limit of a client": (
        lambda: Events(limit_per_client=-1),
        r"^events: limit_per_client is -1;",
    ),
    "every": (
        lambda: Liveness().every(0.0, print),
        r"^every\(\): the period 0\.0 s must be above 0$",
    ),
    "misspelt": (
        lambda: jauspy.Component("1.1.1", [Misspelt()]),
        r"is loaded \(did you mean urn:jaus:jss:mobility:PrimitiveDriver\? one of your own",
    ),
    "unknown": (
        lambda: jauspy.Component("1.1.1", [Unknown()]),
        r"no definition of urn:example:Unknown is loaded \(one of your own is given by `definitions=jauspy.load",
    ),
}


@pytest.mark.parametrize(("make", "words"), OUT_OF_RANGE.values(), ids=OUT_OF_RANGE)
def test_values_out_of_range_raise_errors_with_the_range(make, words):
    with pytest.raises(jauspy.ConfigError, match=words):
        make()


def test_host_of_an_unattached_service_error_explains_it():
    with pytest.raises(
        AttributeError, match=r"^'Early' object has no attribute 'host'; it is there from `attached\(\)`"
    ):
        Early()
    with pytest.raises(AttributeError, match=r"^'Liveness' object has no attribute 'hots'$"):
        Liveness().hots  # noqa: B018 - it is the access that fails


def test_failing_property_keeps_its_error():
    class Battery(Liveness):
        bus = None

        @property
        def charge(self):
            return self.bus.read()

    with pytest.raises(AttributeError, match="'NoneType' object has no attribute 'read'"):
        Battery().charge  # noqa: B018 - it is the access that fails
