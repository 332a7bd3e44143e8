"""urn:jaus:jss:mobility:ListManager 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.core.v1_1 import list_manager as core_v1_1_list_manager


class SetElement(core_v1_1_list_manager.SetElement):
    """SetElement (0x041A): Inserts elements into the list, or replaces them."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:ListManager"
    VERSION = "1.0"


class DeleteElement(core_v1_1_list_manager.DeleteElement):
    """DeleteElement (0x041B): Deletes elements from the list."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:ListManager"
    VERSION = "1.0"


class QueryElement(core_v1_1_list_manager.QueryElement):
    """QueryElement (0x241A): Asks for one element of the list."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:ListManager"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportElement]]


class QueryElementList(core_v1_1_list_manager.QueryElementList):
    """QueryElementList (0x241B): Asks for the identifiers of all elements."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:ListManager"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportElementList]]


class QueryElementCount(core_v1_1_list_manager.QueryElementCount):
    """QueryElementCount (0x241C): Asks for the number of elements."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:ListManager"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportElementCount]]


class ConfirmElementRequest(core_v1_1_list_manager.ConfirmElementRequest):
    """ConfirmElementRequest (0x041C): Tells that a change of the list has been carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:ListManager"
    VERSION = "1.0"


class RejectElementRequest(core_v1_1_list_manager.RejectElementRequest):
    """RejectElementRequest (0x041D): Tells that a change of the list has been refused, and why."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:ListManager"
    VERSION = "1.0"


class ReportElement(core_v1_1_list_manager.ReportElement):
    """ReportElement (0x441A): Carries one element of the list."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:ListManager"
    VERSION = "1.0"


class ReportElementList(core_v1_1_list_manager.ReportElementList):
    """ReportElementList (0x441B): Tells the identifiers of all elements, in list order."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:ListManager"
    VERSION = "1.0"


class ReportElementCount(core_v1_1_list_manager.ReportElementCount):
    """ReportElementCount (0x441C): Tells the number of elements."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:ListManager"
    VERSION = "1.0"


QueryElement.REPORT = ReportElement
QueryElementList.REPORT = ReportElementList
QueryElementCount.REPORT = ReportElementCount
