"""Convoy: which vehicle of a column follows which (IOP v3)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from jauspy.messages.iop import ReportConvoyDetails, UpdateConvoyDetails
from jauspy.services.service import Service

MAX_ORDERS: Final = 256
"""Vehicles that follow another one, in all convoys together."""
SUBSYSTEMS: Final = range(1, 0xFFFF)


class Convoy(Service, urn="urn:jaus:jss:iop:Convoy"):
    """Keeps the convoys that the controlling client has set, which replace all earlier ones.

    A make-up in which a vehicle follows two others, or itself along any chain of vehicles, is refused and counted, as
    is one of more than `MAX_ORDERS` followers, and a convoy whose head follows a vehicle of it.
    """

    def __init__(self) -> None:
        self._report = ReportConvoyDetails([])
        self._leaders: dict[int, int] = {}

    def leader_of(self, subsystem: int) -> int | None:
        """The subsystem that this one follows; None if no convoy names it."""
        return self._leaders.get(subsystem)

    def send_report_convoy_details(self) -> ReportConvoyDetails:
        """All convoys (F102)."""
        return self._report

    def update_convoy_details(self, msg: UpdateConvoyDetails) -> None:
        """Take over the make-up of all convoys (F101)."""
        orders = [order for convoy in msg.convoy_list for order in convoy.convoy_order_list]
        problem = _problem([(order.leader_id, order.vehicle_id) for order in orders])
        if problem := problem or next(filter(None, map(_problem_of_head, msg.convoy_list)), ""):
            self.host.count("bad_convoy", problem)
            self.host.begin_command()(False)
            return
        self._leaders = {order.vehicle_id: order.leader_id for order in orders}
        self._report = ReportConvoyDetails(
            [
                ReportConvoyDetails.ConvoySeq(
                    ReportConvoyDetails.ConvoyRecord(convoy.convoy_record.convoy_id, convoy.convoy_record.head_id),
                    [
                        ReportConvoyDetails.ConvoyOrderRec(order.leader_id, order.vehicle_id)
                        for order in convoy.convoy_order_list
                    ],
                )
                for convoy in msg.convoy_list
            ]
        )


def _problem(orders: list[tuple[int, int]]) -> str:
    """Why vehicles cannot follow each other like this; empty if they can. `orders`: leaders, each with a follower."""
    if len(orders) > MAX_ORDERS:
        return f"{len(orders)} vehicles follow others; the most is {MAX_ORDERS}"
    followers = [follower for _, follower in orders]
    if len(set(followers)) < len(followers):
        return "a vehicle follows two others"
    if any(number not in SUBSYSTEMS for order in orders for number in order):
        return "a number is not that of a subsystem, 1..65534"
    return _ring({follower: leader for leader, follower in orders})


def _ring(leaders: Mapping[int, int]) -> str:
    """Names a vehicle that follows itself, directly or behind others; empty if there is none."""
    checked: set[int] = set()
    for vehicle in leaders:
        column: list[int] = []
        ahead: int | None = vehicle
        while ahead is not None and ahead not in checked:
            checked.add(ahead)
            column.append(ahead)
            ahead = leaders.get(ahead)
        if ahead in column:
            return f"vehicle {ahead} follows itself: no vehicle of its convoy is at the front"
    return ""


def _problem_of_head(convoy: UpdateConvoyDetails.ConvoySeq) -> str:
    """Why the vehicle at the front of a convoy is not there; empty if it is."""
    head = convoy.convoy_record.head_id
    ahead = next((order.leader_id for order in convoy.convoy_order_list if order.vehicle_id == head), None)
    return "" if ahead is None else f"vehicle {head} is the head of its convoy, and follows {ahead}"
