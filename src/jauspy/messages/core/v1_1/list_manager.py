"""urn:jaus:jss:core:ListManager 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages import registry as _registry
from jauspy.messages.core.v1_0 import types as core_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:core:ListManager", "1.1")


@jd.message(_SERVICE, 0x041A, command=True)
class SetElement(jd.Message):
    """SetElement (0x041A): Inserts elements into the list, or replaces them.

    request_id_rec: The number of the request
    element_list: 0..255 items. The elements
    """
    ElementRec = core_v1_0_types.ElementRec

    @jd.record()
    class RequestIDRec(jd.Struct):
        """The number of the request.

        request_id: Repeated in the answer, to match it with its request
        """
        request_id: int = jd.field("RequestID", jd.Number("B"))

    request_id_rec: SetElement.RequestIDRec = jd.field("RequestIDRec", lambda: SetElement.RequestIDRec.layout())
    element_list: list[core_v1_0_types.ElementRec] = jd.field("ElementList", lambda: jd.Repeat(jd.Count("B", 0, 255), core_v1_0_types.ElementRec.layout()))


@jd.message(_SERVICE, 0x041B, command=True)
class DeleteElement(jd.Message):
    """DeleteElement (0x041B): Deletes elements from the list.

    request_id_rec: The number of the request
    delete_element_list: 0..255 items. The elements to delete
    """

    @jd.record()
    class RequestIDRec(jd.Struct):
        """The number of the request.

        request_id: Repeated in the answer, to match it with its request
        """
        request_id: int = jd.field("RequestID", jd.Number("B"))

    @jd.record()
    class DeleteElementRec(jd.Struct):
        """One element to delete.

        element_uid: Identifies the element
        """
        element_uid: int = jd.field("ElementUID", jd.Number("H"))

    request_id_rec: DeleteElement.RequestIDRec = jd.field("RequestIDRec", lambda: DeleteElement.RequestIDRec.layout())
    delete_element_list: list[DeleteElement.DeleteElementRec] = jd.field("DeleteElementList", lambda: jd.Repeat(jd.Count("B", 0, 255), DeleteElement.DeleteElementRec.layout()))


@jd.message(_SERVICE, 0x441A)
class ReportElement(jd.Message):
    """ReportElement (0x441A): Carries one element of the list.

    element_uid: Identifies the element
    previous_uid: The element before this one; 0 when it is the first
    next_uid: The element after this one; 0 when it is the last
    element_data: What the element carries
    """

    class ElementDataFormat(IntEnum):
        JAUS_MESSAGE = 0
        USER_DEFINED = 1

    @jd.variable(lambda cls: jd.Formatted(cls, jd.Values(ReportElement.ElementDataFormat), jd.Count("H", 0, 65535), _registry, frozenset({0})))
    class ElementData(jd.Struct):
        """What the element carries."""
        format: ReportElement.ElementDataFormat | int
        data: jd.Message | bytes

    element_uid: int = jd.field("ElementUID", jd.Number("H"))
    previous_uid: int = jd.field("PreviousUID", jd.Number("H"))
    next_uid: int = jd.field("NextUID", jd.Number("H"))
    element_data: ReportElement.ElementData = jd.field("ElementData", lambda: ReportElement.ElementData.layout())


@jd.message(_SERVICE, 0x241A, query=True)
class QueryElement(jd.Message):
    """QueryElement (0x241A): Asks for one element of the list.

    element_uid: Identifies the element
    """
    REPORT = ReportElement
    element_uid: int = jd.field("ElementUID", jd.Number("H"))


@jd.message(_SERVICE, 0x441B)
class ReportElementList(jd.Message):
    """ReportElementList (0x441B): Tells the identifiers of all elements, in list order.

    element_list: 0..65535 items. The elements
    """

    @jd.record()
    class ElementListRec(jd.Struct):
        """One element.

        element_uid: Identifies the element
        """
        element_uid: int = jd.field("ElementUID", jd.Number("H"))

    element_list: list[ReportElementList.ElementListRec] = jd.field("ElementList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportElementList.ElementListRec.layout()))


@jd.message(_SERVICE, 0x241B, query=True)
class QueryElementList(jd.Message):
    """QueryElementList (0x241B): Asks for the identifiers of all elements."""
    REPORT = ReportElementList


@jd.message(_SERVICE, 0x441C)
class ReportElementCount(jd.Message):
    """ReportElementCount (0x441C): Tells the number of elements.

    element_count: Number of elements
    """
    element_count: int = jd.field("ElementCount", jd.Number("H"))


@jd.message(_SERVICE, 0x241C, query=True)
class QueryElementCount(jd.Message):
    """QueryElementCount (0x241C): Asks for the number of elements."""
    REPORT = ReportElementCount


@jd.message(_SERVICE, 0x041C)
class ConfirmElementRequest(jd.Message):
    """ConfirmElementRequest (0x041C): Tells that a change of the list has been carried out.

    request_id: Repeated in the answer, to match it with its request
    """
    request_id: int = jd.field("RequestID", jd.Number("B"))


@jd.message(_SERVICE, 0x041D)
class RejectElementRequest(jd.Message):
    """RejectElementRequest (0x041D): Tells that a change of the list has been refused, and why.

    request_id: Repeated in the answer, to match it with its request
    response_code: ResponseCode. The reason
    """

    class ResponseCode(IntEnum):
        INVALID_ELEMENT_ID = 1
        INVALID_PREVIOUS_ELEMENT = 2
        INVALID_NEXT_ELEMENT = 3
        UNSUPPORTED_ELEMENT_TYPE = 4
        ELEMENT_NOT_FOUND = 5
        OUT_OF_MEMORY = 6
        UNSPECIFIED_ERROR = 7

    request_id: int = jd.field("RequestID", jd.Number("B"))
    response_code: RejectElementRequest.ResponseCode | int = jd.field("ResponseCode", lambda: jd.Number("B", jd.Values(RejectElementRequest.ResponseCode)))
