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

    request_id_rec: The number of the request
    element_list: 0..255 items. The elements
    """

    CODE = 0x041A
    NAME = "SetElement"
    SERVICE = "urn:jaus:jss:core:ListManager"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    ElementRec = core_v1_0_types.ElementRec

    @dataclass(slots=True, repr=False)
    class RequestIDRec(rt.Struct):
        """The number of the request.

        request_id: Repeated in the answer, to match it with its request
        """

        request_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("RequestID", rt.Number("B")),
            )

    request_id_rec: SetElement.RequestIDRec
    element_list: list[core_v1_0_types.ElementRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIDRec", SetElement.RequestIDRec.layout()),
            ("ElementList", rt.Repeat(rt.Count("B", 0, 255), core_v1_0_types.ElementRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1A or data[1] != 0x04: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_id_ = data[2]
        self.request_id_rec = SetElement.RequestIDRec(request_id_)
        element_list_count_ = data[3]
        if element_list_count_ * 9 > size - 4: raise rt.Reject
        at = 4
        element_list_ = []
        for _ in range(element_list_count_):
            item_ = rt.new(core_v1_0_types.ElementRec)
            item_.element_uid, item_.previous_uid, item_.next_uid = _S_3H.unpack_from(data, at)
            at += 6
            item_.element_data, at = core_v1_0_types.ElementRec.ElementData._read(data, at, nesting)
            element_list_.append(item_)
        self.element_list = element_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1a\x04")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not SetElement.RequestIDRec: raise rt.Reject
        out.append(request_id_rec_.request_id)
        element_list_ = self.element_list
        if type(element_list_) is not list: raise rt.Reject
        out.append(len(element_list_))
        for item_ in element_list_:
            if type(item_) is not core_v1_0_types.ElementRec: raise rt.Reject
            out += _S_3H.pack(item_.element_uid, item_.previous_uid, item_.next_uid)
            element_data_ = item_.element_data
            if type(element_data_) is not core_v1_0_types.ElementRec.ElementData: raise rt.Reject
            element_data_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class DeleteElement(rt.Message):
    """DeleteElement (0x041B): Deletes elements from the list.

    request_id_rec: The number of the request
    delete_element_list: 0..255 items. The elements to delete
    """

    CODE = 0x041B
    NAME = "DeleteElement"
    SERVICE = "urn:jaus:jss:core:ListManager"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class RequestIDRec(rt.Struct):
        """The number of the request.

        request_id: Repeated in the answer, to match it with its request
        """

        request_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("RequestID", rt.Number("B")),
            )

    @dataclass(slots=True, repr=False)
    class DeleteElementRec(rt.Struct):
        """One element to delete.

        element_uid: Identifies the element
        """

        element_uid: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ElementUID", rt.Number("H")),
            )

    request_id_rec: DeleteElement.RequestIDRec
    delete_element_list: list[DeleteElement.DeleteElementRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIDRec", DeleteElement.RequestIDRec.layout()),
            ("DeleteElementList", rt.Repeat(rt.Count("B", 0, 255), DeleteElement.DeleteElementRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1B or data[1] != 0x04: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_id_ = data[2]
        self.request_id_rec = DeleteElement.RequestIDRec(request_id_)
        delete_element_list_count_ = data[3]
        delete_element_list_end_ = 4 + delete_element_list_count_ * 2
        self.delete_element_list = [DeleteElement.DeleteElementRec(element_uid_) for element_uid_ in _L_H[delete_element_list_count_].unpack_from(data, 4)]
        if delete_element_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1b\x04")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not DeleteElement.RequestIDRec: raise rt.Reject
        out.append(request_id_rec_.request_id)
        delete_element_list_ = self.delete_element_list
        if type(delete_element_list_) is not list: raise rt.Reject
        out.append(len(delete_element_list_))
        raw_: list[int | float] = []
        for item_ in delete_element_list_:
            if type(item_) is not DeleteElement.DeleteElementRec: raise rt.Reject
            raw_.append(item_.element_uid)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryElement(rt.Message):
    """QueryElement (0x241A): Asks for one element of the list.

    element_uid: Identifies the element
    """

    CODE = 0x241A
    NAME = "QueryElement"
    SERVICE = "urn:jaus:jss:core:ListManager"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportElement]]

    element_uid: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ElementUID", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.element_uid = _S_2H.unpack(data)
        if code != 0x241A: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x241A, self.element_uid)


@dataclass(slots=True, repr=False)
class QueryElementList(rt.Message):
    """QueryElementList (0x241B): Asks for the identifiers of all elements."""

    CODE = 0x241B
    NAME = "QueryElementList"
    SERVICE = "urn:jaus:jss:core:ListManager"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportElementList]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x1b$': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x241B)


@dataclass(slots=True, repr=False)
class QueryElementCount(rt.Message):
    """QueryElementCount (0x241C): Asks for the number of elements."""

    CODE = 0x241C
    NAME = "QueryElementCount"
    SERVICE = "urn:jaus:jss:core:ListManager"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportElementCount]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x1c$': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x241C)


@dataclass(slots=True, repr=False)
class ConfirmElementRequest(rt.Message):
    """ConfirmElementRequest (0x041C): Tells that a change of the list has been carried out.

    request_id: Repeated in the answer, to match it with its request
    """

    CODE = 0x041C
    NAME = "ConfirmElementRequest"
    SERVICE = "urn:jaus:jss:core:ListManager"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    request_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestID", rt.Number("B")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.request_id = _S_HB.unpack(data)
        if code != 0x041C: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x041C, self.request_id)


@dataclass(slots=True, repr=False)
class RejectElementRequest(rt.Message):
    """RejectElementRequest (0x041D): Tells that a change of the list has been refused, and why.

    request_id: Repeated in the answer, to match it with its request
    response_code: ResponseCode. The reason
    """

    CODE = 0x041D
    NAME = "RejectElementRequest"
    SERVICE = "urn:jaus:jss:core:ListManager"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

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
        return rt.composite(
            cls, None,
            ("RequestID", rt.Number("B")),
            ("ResponseCode", rt.Number("B", rt.Values(RejectElementRequest.ResponseCode))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.request_id, response_code_ = _S_H2B.unpack(data)
        if code != 0x041D: raise rt.Reject
        self.response_code = _E_RejectElementRequest_ResponseCode[response_code_]
        return self

    def _pack(self) -> bytes:
        response_code_ = self.response_code
        if response_code_ not in _E_RejectElementRequest_ResponseCode: raise rt.Reject
        return _S_H2B.pack(0x041D, self.request_id, response_code_)


@dataclass(slots=True, repr=False)
class ReportElement(rt.Message):
    """ReportElement (0x441A): Carries one element of the list.

    element_uid: Identifies the element
    previous_uid: The element before this one; 0 when it is the first
    next_uid: The element after this one; 0 when it is the last
    element_data: What the element carries
    """

    CODE = 0x441A
    NAME = "ReportElement"
    SERVICE = "urn:jaus:jss:core:ListManager"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

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
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            format = data[at]
            self.format = _E_ReportElement_ElementDataFormat[format]
            (data_end_,) = _S_H.unpack_from(data, at + 1)
            data_end_ += at + 3
            self.data = (nesting or _registry.nesting).message(data[at + 3:data_end_]) if format in {0} else data[at + 3:data_end_]
            return self, data_end_

        def _write(self, out: bytearray) -> None:
            format = self.format
            if format not in _E_ReportElement_ElementDataFormat: raise rt.Reject
            out.append(format)
            data_raw_ = rt.message_bytes(self.data) if format in {0} else rt.plain_bytes(self.data)
            out += _S_H.pack(len(data_raw_))
            out += data_raw_

    element_uid: int
    previous_uid: int
    next_uid: int
    element_data: ReportElement.ElementData

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ElementUID", rt.Number("H")),
            ("PreviousUID", rt.Number("H")),
            ("NextUID", rt.Number("H")),
            ("ElementData", ReportElement.ElementData.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1A or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        self.element_uid, self.previous_uid, self.next_uid = _S_3H.unpack_from(data, 2)
        at = 8
        self.element_data, at = ReportElement.ElementData._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1a\x44")
        out += _S_3H.pack(self.element_uid, self.previous_uid, self.next_uid)
        element_data_ = self.element_data
        if type(element_data_) is not ReportElement.ElementData: raise rt.Reject
        element_data_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportElementList(rt.Message):
    """ReportElementList (0x441B): Tells the identifiers of all elements, in list order.

    element_list: 0..65535 items. The elements
    """

    CODE = 0x441B
    NAME = "ReportElementList"
    SERVICE = "urn:jaus:jss:core:ListManager"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class ElementListRec(rt.Struct):
        """One element.

        element_uid: Identifies the element
        """

        element_uid: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ElementUID", rt.Number("H")),
            )

    element_list: list[ReportElementList.ElementListRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ElementList", rt.Repeat(rt.Count("H", 0, 65535), ReportElementList.ElementListRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1B or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (element_list_count_,) = _S_H.unpack_from(data, 2)
        element_list_end_ = 4 + element_list_count_ * 2
        self.element_list = [ReportElementList.ElementListRec(element_uid_) for element_uid_ in _L_H[element_list_count_].unpack_from(data, 4)]
        if element_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1b\x44")
        element_list_ = self.element_list
        if type(element_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(element_list_))
        raw_: list[int | float] = []
        for item_ in element_list_:
            if type(item_) is not ReportElementList.ElementListRec: raise rt.Reject
            raw_.append(item_.element_uid)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportElementCount(rt.Message):
    """ReportElementCount (0x441C): Tells the number of elements.

    element_count: Number of elements
    """

    CODE = 0x441C
    NAME = "ReportElementCount"
    SERVICE = "urn:jaus:jss:core:ListManager"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    element_count: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ElementCount", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.element_count = _S_2H.unpack(data)
        if code != 0x441C: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x441C, self.element_count)


_S_3H = rt.Packer("<3H")
_L_H = rt.Rows("H")
_S_2H = rt.Packer("<2H")
_S_H = rt.Packer("<H")
_S_HB = rt.Packer("<HB")
_E_RejectElementRequest_ResponseCode = rt.members(RejectElementRequest.ResponseCode)
_S_H2B = rt.Packer("<H2B")
_E_ReportElement_ElementDataFormat = rt.members(ReportElement.ElementDataFormat)
QueryElement.REPORT = ReportElement
QueryElementList.REPORT = ReportElementList
QueryElementCount.REPORT = ReportElementCount
