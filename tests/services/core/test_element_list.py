"""Links of a list: what fits is inserted, what does not is refused with the right code and changes nothing."""

from __future__ import annotations

import pytest
from hypothesis import given, strategies as st

from jauspy.messages.core import ElementRec, RejectElementRequest, ReportStatus
from jauspy.services.core.list_manager import ElementList

Code = RejectElementRequest.ResponseCode
DATA = ElementRec.ElementData(0, ReportStatus(status=1, reserved=0))


def records(*links: tuple[int, int, int]) -> list[ElementRec]:
    """Each (uid, previous, next)."""
    return [ElementRec(*each, DATA) for each in links]


LIST = ElementList((1, 2, 3))
RING = ElementList((1, 2, 3), loop=True)


@pytest.mark.parametrize(
    ("before", "links", "after"),
    [
        (ElementList(), [(7, 0, 0)], ElementList((7,))),
        (ElementList(), [(1, 0, 2), (2, 1, 3), (3, 2, 0)], LIST),
        (ElementList(), [(3, 2, 0), (1, 0, 2), (2, 1, 3)], LIST),
        (ElementList(), [(1, 0, 2), (2, 1, 3), (3, 2, 1)], RING),
        (ElementList(), [(1, 3, 2), (2, 1, 3), (3, 2, 1)], RING),
        (LIST, [(4, 3, 0)], ElementList((1, 2, 3, 4))),
        (LIST, [(4, 0, 1)], ElementList((4, 1, 2, 3))),
        (LIST, [(4, 1, 2)], ElementList((1, 4, 2, 3))),
        (LIST, [(4, 1, 5), (5, 4, 2)], ElementList((1, 4, 5, 2, 3))),
        (LIST, [(2, 1, 3)], LIST),
        (LIST, [(2, 3, 0)], ElementList((1, 3, 2))),
        (LIST, [(3, 2, 1)], RING),
        (RING, [(3, 2, 0)], LIST),
        (RING, [(1, 3, 2)], RING),
        (RING, [(4, 3, 1)], ElementList((1, 2, 3, 4), loop=True)),
        (ElementList(), [(1, 0, 1)], ElementList((1,), loop=True)),
    ],
)
def test_valid_elements_are_linked(before, links, after) -> None:
    assert before.linked(records(*links)) == after


@pytest.mark.parametrize(
    ("before", "links", "code"),
    [
        (LIST, [], Code.UNSPECIFIED_ERROR),
        (LIST, [(0, 3, 0)], Code.INVALID_ELEMENT_ID),
        (LIST, [(65535, 3, 0)], Code.INVALID_ELEMENT_ID),
        (LIST, [(4, 3, 0), (4, 3, 0)], Code.INVALID_ELEMENT_ID),
        (LIST, [(4, 9, 0)], Code.INVALID_PREVIOUS_ELEMENT),
        (LIST, [(4, 3, 0), (5, 3, 0)], Code.INVALID_PREVIOUS_ELEMENT),
        (LIST, [(4, 4, 0)], Code.INVALID_PREVIOUS_ELEMENT),
        (LIST, [(4, 5, 5), (5, 4, 4)], Code.INVALID_PREVIOUS_ELEMENT),
        (LIST, [(4, 3, 9)], Code.INVALID_NEXT_ELEMENT),
        (LIST, [(4, 0, 0)], Code.INVALID_NEXT_ELEMENT),
        (LIST, [(4, 1, 3)], Code.INVALID_NEXT_ELEMENT),
        (LIST, [(4, 1, 0)], Code.INVALID_NEXT_ELEMENT),
        (ElementList(), [(1, 9, 0)], Code.INVALID_PREVIOUS_ELEMENT),
        (ElementList(), [(1, 0, 2), (2, 1, 3), (3, 2, 4), (4, 3, 5)], Code.INVALID_NEXT_ELEMENT),
        (ElementList(), [(1, 0, 2), (2, 1, 2)], Code.INVALID_NEXT_ELEMENT),
    ],
)
def test_inconsistent_elements_are_rejected(before, links, code) -> None:
    assert before.linked(records(*links)) is code


def test_deletion_links_the_neighbours() -> None:
    rest = ElementList((1, 2, 3, 4)).without({2, 3, 9})
    assert rest == ElementList((1, 4))
    assert (rest.previous(1), rest.next(1), rest.previous(4), rest.next(4)) == (0, 4, 1, 0)
    assert RING.without({1}).next(3) == 2
    assert RING.without({1, 2, 3}) == ElementList()


@given(st.lists(st.tuples(*[st.integers(0, 6)] * 3), max_size=5))
def test_accepted_lists_match_the_request(links) -> None:
    asked = records(*links)
    changed = LIST.linked(asked)
    if isinstance(changed, Code):
        return
    assert sorted(changed.order) == sorted({1, 2, 3} | {each.element_uid for each in asked})
    for each in asked:
        assert each.next_uid == changed.next(each.element_uid)
        assert each.previous_uid in (changed.previous(each.element_uid), 0)
