"""urn:jaus:jss:core:ListManager 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

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

    ElementRec = core_v1_0_types.ElementRec

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

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            request_id_ = data[at]
            at += 1
            return cls(request_id_), at

        def _write(self, out: bytearray) -> None:
            request_id_ = self.request_id
            out += _S_B.pack(request_id_)

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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0x1A or data[1] != 0x04:
            raise rt.Reject
        at = 2
        size = len(data)
        request_id_rec_request_id_ = data[at]
        at += 1
        request_id_rec_ = SetElement.RequestIDRec(request_id_rec_request_id_)
        element_list_count = data[at]
        at += 1
        if element_list_count * 9 > size - at:
            raise rt.Reject
        element_list_ = []
        for _ in range(element_list_count):
            element_list_item_element_uid_, element_list_item_previous_uid_, element_list_item_next_uid_ = _S_3H.unpack_from(data, at)
            at += 6
            element_list_item_element_data_, at = core_v1_0_types.ElementRec.ElementData._read(data, at, depth)
            element_list_item_ = core_v1_0_types.ElementRec(element_list_item_element_uid_, element_list_item_previous_uid_, element_list_item_next_uid_, element_list_item_element_data_)
            element_list_.append(element_list_item_)
        if at != len(data):
            raise rt.Reject
        return cls(request_id_rec_, element_list_)

    def _pack(self) -> bytes:
        out = bytearray(b"\x1a\x04")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not SetElement.RequestIDRec:
            raise rt.Reject
        request_id_rec_request_id_ = request_id_rec_.request_id
        out += _S_B.pack(request_id_rec_request_id_)
        element_list_ = self.element_list
        if type(element_list_) is not list:
            raise rt.Reject
        out.append(len(element_list_))
        for element_list_item_ in element_list_:
            if type(element_list_item_) is not core_v1_0_types.ElementRec:
                raise rt.Reject
            element_list_item_element_uid_ = element_list_item_.element_uid
            element_list_item_previous_uid_ = element_list_item_.previous_uid
            element_list_item_next_uid_ = element_list_item_.next_uid
            out += _S_3H.pack(element_list_item_element_uid_, element_list_item_previous_uid_, element_list_item_next_uid_)
            element_list_item_element_data_ = element_list_item_.element_data
            if type(element_list_item_element_data_) is not core_v1_0_types.ElementRec.ElementData:
                raise rt.Reject
            element_list_item_element_data_._write(out)
        return bytes(out)


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

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            request_id_ = data[at]
            at += 1
            return cls(request_id_), at

        def _write(self, out: bytearray) -> None:
            request_id_ = self.request_id
            out += _S_B.pack(request_id_)

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

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            (element_uid_,) = _S_H.unpack_from(data, at)
            at += 2
            return cls(element_uid_), at

        def _write(self, out: bytearray) -> None:
            element_uid_ = self.element_uid
            out += _S_H.pack(element_uid_)

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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0x1B or data[1] != 0x04:
            raise rt.Reject
        at = 2
        size = len(data)
        request_id_rec_request_id_ = data[at]
        at += 1
        request_id_rec_ = DeleteElement.RequestIDRec(request_id_rec_request_id_)
        delete_element_list_count = data[at]
        at += 1
        delete_element_list_end = at + delete_element_list_count * 2
        if delete_element_list_end > size:
            raise rt.Reject
        delete_element_list_ = [DeleteElement.DeleteElementRec(delete_element_list_item_element_uid_) for (delete_element_list_item_element_uid_,) in _S_H.iter_unpack(data[at:delete_element_list_end])]
        at = delete_element_list_end
        if at != len(data):
            raise rt.Reject
        return cls(request_id_rec_, delete_element_list_)

    def _pack(self) -> bytes:
        out = bytearray(b"\x1b\x04")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not DeleteElement.RequestIDRec:
            raise rt.Reject
        request_id_rec_request_id_ = request_id_rec_.request_id
        out += _S_B.pack(request_id_rec_request_id_)
        delete_element_list_ = self.delete_element_list
        if type(delete_element_list_) is not list:
            raise rt.Reject
        out.append(len(delete_element_list_))
        for delete_element_list_item_ in delete_element_list_:
            if type(delete_element_list_item_) is not DeleteElement.DeleteElementRec:
                raise rt.Reject
            delete_element_list_item_element_uid_ = delete_element_list_item_.element_uid
            out += _S_H.pack(delete_element_list_item_element_uid_)
        return bytes(out)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, element_uid_ = _S_2H.unpack(data)
        if code != 0x241A:
            raise rt.Reject
        return cls(element_uid_)

    def _pack(self) -> bytes:
        element_uid_ = self.element_uid
        return _S_2H.pack(0x241A, element_uid_)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, = _S_H.unpack(data)
        if code != 0x241B:
            raise rt.Reject
        return cls()

    def _pack(self) -> bytes:
        return _S_H.pack(0x241B)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, = _S_H.unpack(data)
        if code != 0x241C:
            raise rt.Reject
        return cls()

    def _pack(self) -> bytes:
        return _S_H.pack(0x241C)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, request_id_ = _S_HB.unpack(data)
        if code != 0x041C:
            raise rt.Reject
        return cls(request_id_)

    def _pack(self) -> bytes:
        request_id_ = self.request_id
        return _S_HB.pack(0x041C, request_id_)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, request_id_, response_code_ = _S_H2B.unpack(data)
        if code != 0x041D:
            raise rt.Reject
        return cls(request_id_, _E_RejectElementRequest_ResponseCode[response_code_])

    def _pack(self) -> bytes:
        request_id_ = self.request_id
        response_code_ = self.response_code
        if response_code_ not in _E_RejectElementRequest_ResponseCode:
            raise rt.Reject
        return _S_H2B.pack(0x041D, request_id_, response_code_)


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

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            size = len(data)
            format = data[at]
            at += 1
            (data_end,) = _S_H.unpack_from(data, at)
            at += 2
            data_end += at
            if data_end > size:
                raise rt.Reject
            chunk = data[at:data_end]
            content: rt.Message | bytes = chunk
            if format == 0:
                content = _registry.nested(chunk, depth)
            return cls(_E_ReportElement_ElementDataFormat[format], content), data_end

        def _write(self, out: bytearray) -> None:
            format = self.format
            if format not in _E_ReportElement_ElementDataFormat:
                raise rt.Reject
            raw = rt.message_bytes(self.data) if format == 0 else rt.plain_bytes(self.data)
            out.append(format)
            out += _S_H.pack(len(raw))
            out += raw

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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0x1A or data[1] != 0x44:
            raise rt.Reject
        at = 2
        element_uid_, previous_uid_, next_uid_ = _S_3H.unpack_from(data, at)
        at += 6
        element_data_, at = ReportElement.ElementData._read(data, at, depth)
        if at != len(data):
            raise rt.Reject
        return cls(element_uid_, previous_uid_, next_uid_, element_data_)

    def _pack(self) -> bytes:
        out = bytearray(b"\x1a\x44")
        element_uid_ = self.element_uid
        previous_uid_ = self.previous_uid
        next_uid_ = self.next_uid
        out += _S_3H.pack(element_uid_, previous_uid_, next_uid_)
        element_data_ = self.element_data
        if type(element_data_) is not ReportElement.ElementData:
            raise rt.Reject
        element_data_._write(out)
        return bytes(out)


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

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            (element_uid_,) = _S_H.unpack_from(data, at)
            at += 2
            return cls(element_uid_), at

        def _write(self, out: bytearray) -> None:
            element_uid_ = self.element_uid
            out += _S_H.pack(element_uid_)

    element_list: list[ReportElementList.ElementListRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("element_list", "ElementList", rt.Repeat(rt.Count("H", 0, 65535), ReportElementList.ElementListRec.layout())),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0x1B or data[1] != 0x44:
            raise rt.Reject
        at = 2
        size = len(data)
        (element_list_count,) = _S_H.unpack_from(data, at)
        at += 2
        element_list_end = at + element_list_count * 2
        if element_list_end > size:
            raise rt.Reject
        element_list_ = [ReportElementList.ElementListRec(element_list_item_element_uid_) for (element_list_item_element_uid_,) in _S_H.iter_unpack(data[at:element_list_end])]
        at = element_list_end
        if at != len(data):
            raise rt.Reject
        return cls(element_list_)

    def _pack(self) -> bytes:
        out = bytearray(b"\x1b\x44")
        element_list_ = self.element_list
        if type(element_list_) is not list:
            raise rt.Reject
        out += _S_H.pack(len(element_list_))
        for element_list_item_ in element_list_:
            if type(element_list_item_) is not ReportElementList.ElementListRec:
                raise rt.Reject
            element_list_item_element_uid_ = element_list_item_.element_uid
            out += _S_H.pack(element_list_item_element_uid_)
        return bytes(out)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, element_count_ = _S_2H.unpack(data)
        if code != 0x441C:
            raise rt.Reject
        return cls(element_count_)

    def _pack(self) -> bytes:
        element_count_ = self.element_count
        return _S_2H.pack(0x441C, element_count_)


_S_B = rt.Packer("<B")
_S_3H = rt.Packer("<3H")
_S_H = rt.Packer("<H")
_S_2H = rt.Packer("<2H")
_S_HB = rt.Packer("<HB")
_E_RejectElementRequest_ResponseCode = {member.value: member for member in RejectElementRequest.ResponseCode}
_S_H2B = rt.Packer("<H2B")
_E_ReportElement_ElementDataFormat = {member.value: member for member in ReportElement.ElementDataFormat}
