"""The inputs of ListManager."""

from __future__ import annotations

from typing import Final

from jauspy.conformance.checks import has
from jauspy.conformance.walk.events import CREATE, UNKNOWN_ID
from jauspy.conformance.walk.stimulus import Stimulus
from jauspy.messages.core import DeleteElement, ElementRec, QueryElement, SetElement, Standby


def _element(uid: int, previous: int = 0) -> SetElement:
    data = ElementRec.ElementData(0, Standby())
    return SetElement(SetElement.RequestIDRec(CREATE), [ElementRec(uid, previous, 0, data)])


LISTS: Final = (
    Stimulus(
        "SetElement",
        lambda _: _element(7, previous=UNKNOWN_ID),
        "after an unknown one",
        {"isValidElementRequest": False},
        checks={"RejectElementRequest": has(request_id=CREATE)},
    ),
    Stimulus("SetElement", lambda _: _element(7), "a command that may be none of a list"),
    Stimulus(
        "DeleteElement",
        lambda _: DeleteElement(DeleteElement.RequestIDRec(CREATE), [DeleteElement.DeleteElementRec(UNKNOWN_ID)]),
        "an unknown one",
        {"elementExists": False},
        checks={"RejectElementRequest": has(request_id=CREATE)},
    ),
    Stimulus(
        "DeleteElement",
        lambda _: DeleteElement(DeleteElement.RequestIDRec(CREATE), [DeleteElement.DeleteElementRec(7)]),
        "one that may be there",
    ),
    Stimulus("QueryElement", lambda _: QueryElement(UNKNOWN_ID), "an unknown one", {"elementExists": False}),
    Stimulus("QueryElement", lambda _: QueryElement(7), "one that may be there"),
)
