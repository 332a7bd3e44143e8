"""urn:jaus:jss:manipulator:ListManager 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.core.v1_1 import list_manager as core_v1_1_list_manager

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ListManager", "1.0")

@jd.derived(_SERVICE)
class SetElement(core_v1_1_list_manager.SetElement): ...

@jd.derived(_SERVICE)
class DeleteElement(core_v1_1_list_manager.DeleteElement): ...

@jd.derived(_SERVICE)
class ReportElement(core_v1_1_list_manager.ReportElement): ...

@jd.derived(_SERVICE)
class QueryElement(core_v1_1_list_manager.QueryElement):
    REPORT = ReportElement

@jd.derived(_SERVICE)
class ReportElementList(core_v1_1_list_manager.ReportElementList): ...

@jd.derived(_SERVICE)
class QueryElementList(core_v1_1_list_manager.QueryElementList):
    REPORT = ReportElementList

@jd.derived(_SERVICE)
class ReportElementCount(core_v1_1_list_manager.ReportElementCount): ...

@jd.derived(_SERVICE)
class QueryElementCount(core_v1_1_list_manager.QueryElementCount):
    REPORT = ReportElementCount

@jd.derived(_SERVICE)
class ConfirmElementRequest(core_v1_1_list_manager.ConfirmElementRequest): ...

@jd.derived(_SERVICE)
class RejectElementRequest(core_v1_1_list_manager.RejectElementRequest): ...
