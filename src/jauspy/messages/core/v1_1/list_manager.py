"""urn:jaus:jss:core:ListManager 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar

from jauspy.codec import runtime as rt
from jauspy.messages import registry as _registry
from jauspy.messages.core.v1_0 import types as core_v1_0_types


@dataclass(slots=True, repr=False)
class SetElement(rt.Message):
    """SetElement (0x041A): Inserts elements into the list, or replaces them.

    request_id_rec: Which request is answered
    element_list: 0..255 items. The elements
    """

    CODE: ClassVar[int] = 0x041A
    NAME: ClassVar[str] = "SetElement"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:ListManager"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    @dataclass(slots=True, repr=False)
    class RequestIDRec(rt.Struct):
        """Which request is answered.

        request_id: Repeated in the answer, to match it with its request
        """

        request_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(
                cls,
                (
                    rt.Slot("request_id", "RequestID", rt.Number("B")),
                ),
            )

    request_id_rec: SetElement.RequestIDRec
    element_list: list[core_v1_0_types.ElementRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("request_id_rec", "RequestIDRec", SetElement.RequestIDRec.layout()),
                rt.Slot("element_list", "ElementList", rt.Repeat(rt.Count("B", 0, 255), core_v1_0_types.ElementRec.layout())),
            ),
        )


@dataclass(slots=True, repr=False)
class DeleteElement(rt.Message):
    """DeleteElement (0x041B): Deletes elements from the list.

    request_id_rec: Which request is answered
    delete_element_list: 0..255 items. The elements to delete
    """

    CODE: ClassVar[int] = 0x041B
    NAME: ClassVar[str] = "DeleteElement"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:ListManager"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    @dataclass(slots=True, repr=False)
    class RequestIDRec(rt.Struct):
        """Which request is answered.

        request_id: Repeated in the answer, to match it with its request
        """

        request_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(
                cls,
                (
                    rt.Slot("request_id", "RequestID", rt.Number("B")),
                ),
            )

    @dataclass(slots=True, repr=False)
    class DeleteElementRec(rt.Struct):
        """One element to delete.

        element_uid: Identifies the element
        """

        element_uid: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(
                cls,
                (
                    rt.Slot("element_uid", "ElementUID", rt.Number("H")),
                ),
            )

    request_id_rec: DeleteElement.RequestIDRec
    delete_element_list: list[DeleteElement.DeleteElementRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("request_id_rec", "RequestIDRec", DeleteElement.RequestIDRec.layout()),
                rt.Slot("delete_element_list", "DeleteElementList", rt.Repeat(rt.Count("B", 0, 255), DeleteElement.DeleteElementRec.layout())),
            ),
        )


@dataclass(slots=True, repr=False)
class QueryElement(rt.Message):
    """QueryElement (0x241A): Asks for one element of the list.

    element_uid: Identifies the element
    """

    CODE: ClassVar[int] = 0x241A
    NAME: ClassVar[str] = "QueryElement"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:ListManager"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    element_uid: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("element_uid", "ElementUID", rt.Number("H")),
            ),
        )


@dataclass(slots=True, repr=False)
class QueryElementList(rt.Message):
    """QueryElementList (0x241B): Asks for the identifiers of all elements."""

    CODE: ClassVar[int] = 0x241B
    NAME: ClassVar[str] = "QueryElementList"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:ListManager"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())


@dataclass(slots=True, repr=False)
class QueryElementCount(rt.Message):
    """QueryElementCount (0x241C): Asks for the number of elements."""

    CODE: ClassVar[int] = 0x241C
    NAME: ClassVar[str] = "QueryElementCount"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:ListManager"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())


@dataclass(slots=True, repr=False)
class ConfirmElementRequest(rt.Message):
    """ConfirmElementRequest (0x041C): Tells that a change of the list has been carried out.

    request_id: Repeated in the answer, to match it with its request
    """

    CODE: ClassVar[int] = 0x041C
    NAME: ClassVar[str] = "ConfirmElementRequest"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:ListManager"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    request_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("request_id", "RequestID", rt.Number("B")),
            ),
        )


@dataclass(slots=True, repr=False)
class RejectElementRequest(rt.Message):
    """RejectElementRequest (0x041D): Tells that a change of the list has been refused, and why.

    request_id: Repeated in the answer, to match it with its request
    response_code: ResponseCode. The reason
    """

    CODE: ClassVar[int] = 0x041D
    NAME: ClassVar[str] = "RejectElementRequest"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:ListManager"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    class ResponseCode(IntEnum):
        """Values of ResponseCode."""

        INVALID_ELEMENT_ID = 1
        INVALID_PREVIOUS_ELEMENT = 2
        INVALID_NEXT_ELEMENT = 3
        UNSUPPORTED_ELEMENT_TYPE = 4
        ELEMENT_NOT_FOUND = 5
        OUT_OF_MEMORY = 6
        UNSPECIFIED_ERROR = 7

    request_id: int
    response_code: RejectElementRequest.ResponseCode | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("request_id", "RequestID", rt.Number("B")),
                rt.Slot("response_code", "ResponseCode", rt.Number("B", rt.Values(RejectElementRequest.ResponseCode))),
            ),
        )


@dataclass(slots=True, repr=False)
class ReportElement(rt.Message):
    """ReportElement (0x441A): Carries one element of the list.

    element_uid: Identifies the element
    previous_uid: The element before this one; 0 when it is the first
    next_uid: The element after this one; 0 when it is the last
    element_data: What the element carries
    """

    CODE: ClassVar[int] = 0x441A
    NAME: ClassVar[str] = "ReportElement"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:ListManager"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    class ElementDataFormat(IntEnum):
        """Values of ElementDataFormat."""

        JAUS_MESSAGE = 0
        USER_DEFINED = 1

    @dataclass(slots=True, repr=False)
    class ElementData(rt.Struct):
        """What the element carries."""

        format: ReportElement.ElementDataFormat | int
        data: rt.Message | bytes

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Formatted(cls, rt.Values(ReportElement.ElementDataFormat), rt.Count("H", 0, 65535), _registry, frozenset({0}))

    element_uid: int
    previous_uid: int
    next_uid: int
    element_data: ReportElement.ElementData

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("element_uid", "ElementUID", rt.Number("H")),
                rt.Slot("previous_uid", "PreviousUID", rt.Number("H")),
                rt.Slot("next_uid", "NextUID", rt.Number("H")),
                rt.Slot("element_data", "ElementData", ReportElement.ElementData.layout()),
            ),
        )


@dataclass(slots=True, repr=False)
class ReportElementList(rt.Message):
    """ReportElementList (0x441B): Tells the identifiers of all elements, in list order.

    element_list: 0..65535 items. The elements
    """

    CODE: ClassVar[int] = 0x441B
    NAME: ClassVar[str] = "ReportElementList"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:ListManager"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    @dataclass(slots=True, repr=False)
    class ElementListRec(rt.Struct):
        """One element.

        element_uid: Identifies the element
        """

        element_uid: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(
                cls,
                (
                    rt.Slot("element_uid", "ElementUID", rt.Number("H")),
                ),
            )

    element_list: list[ReportElementList.ElementListRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("element_list", "ElementList", rt.Repeat(rt.Count("H", 0, 65535), ReportElementList.ElementListRec.layout())),
            ),
        )


@dataclass(slots=True, repr=False)
class ReportElementCount(rt.Message):
    """ReportElementCount (0x441C): Tells the number of elements.

    element_count: Number of elements
    """

    CODE: ClassVar[int] = 0x441C
    NAME: ClassVar[str] = "ReportElementCount"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:ListManager"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    element_count: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("element_count", "ElementCount", rt.Number("H")),
            ),
        )
