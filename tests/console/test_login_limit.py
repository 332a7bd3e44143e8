"""How often a login may fail: guesses of others delay nobody."""

from __future__ import annotations

import asyncio
import threading

import pytest

pytest.importorskip("cryptography", reason="needs the extra 'console'")

from jauspy.console.login_limit import (
    FAILURE_TIME,
    MAX_COUNTED,
    MAX_FAILURES,
    MAX_FAILURES_IN_ALL,
    MAX_FAILURES_OF_ACCOUNT,
    MAX_LOGINS,
    MAX_LOGINS_OF_HOST,
    LoginLimit,
    Turns,
)


def fail(limit: LoginLimit, address: str, now: float = 0.0, *, name: str = "anna", device: str = "") -> None:
    limit.begin(address, name, device, now)


def test_an_address_that_fails_is_delayed_and_others_are_not() -> None:
    limit = LoginLimit()
    for each in range(MAX_FAILURES):
        assert limit.wait("10.0.0.1", "anna", "", float(each)) == 0.0
        fail(limit, "10.0.0.1", float(each))
    assert limit.wait("10.0.0.1", "anna", "", 10.0) == FAILURE_TIME - 10.0
    assert limit.wait("10.0.0.2", "anna", "", 10.0) == 0.0
    assert limit.wait("10.0.0.1", "anna", "", FAILURE_TIME) == 0.0, "the first failure is old"


def test_an_account_that_many_addresses_attack_is_not_locked() -> None:
    limit = LoginLimit()
    for each in range(MAX_FAILURES_IN_ALL):
        fail(limit, f"10.1.0.{each}")
    assert limit.wait("10.9.9.9", "anna", "", 1.0) == 0.0, "an address that has not failed has one attempt"
    fail(limit, "10.9.9.9", 1.0)
    assert limit.wait("10.9.9.9", "anna", "", 2.0) == FAILURE_TIME - 1.0, "and not several"
    assert limit.wait("10.9.9.9", "anna", "", FAILURE_TIME + 2.0) == 0.0
    limit.begin("10.8.8.8", "anna", "", 3.0)()
    assert limit.wait("10.1.0.0", "anna", "", 3.0) > 0.0, "a login that succeeds does not end the attack"


def test_only_the_account_that_is_attacked_is_slow() -> None:
    limit = LoginLimit()
    for each in range(MAX_FAILURES_OF_ACCOUNT):
        fail(limit, f"10.1.0.{each}")
    fail(limit, "10.9.9.9", name="sam")
    assert limit.wait("10.9.9.9", "sam", "", 1.0) == 0.0
    assert limit.wait("10.9.9.9", "anna", "", 1.0) > 0.0


def test_a_device_is_delayed_by_its_own_failures_only() -> None:
    limit = LoginLimit()
    for each in range(MAX_FAILURES_IN_ALL):
        fail(limit, f"10.1.0.{each}")
        fail(limit, "10.0.0.1")
    assert limit.wait("10.0.0.1", "anna", "", 1.0) > 0.0
    for _ in range(MAX_FAILURES):
        assert limit.wait("10.0.0.1", "anna", "laptop", 1.0) == 0.0
        fail(limit, "10.0.0.1", 1.0, device="laptop")
    assert not limit.trusts("laptop", 2.0)
    assert limit.wait("10.0.0.1", "anna", "laptop", 2.0) > 0.0
    assert limit.trusts("laptop", FAILURE_TIME + 1.0)


def test_a_login_that_succeeds_takes_back_itself_only() -> None:
    limit = LoginLimit()
    for each in range(MAX_FAILURES - 1):
        fail(limit, "10.0.0.1", float(each))
    limit.begin("10.0.0.1", "mallory", "", 10.0)()
    assert limit.wait("10.0.0.1", "anna", "", 11.0) == 0.0
    fail(limit, "10.0.0.1", 11.0)
    assert limit.wait("10.0.0.1", "anna", "", 12.0) > 0.0, "his own account does not give a user more guesses"


def test_networks_of_ipv6_count_as_one_and_what_is_remembered_is_bounded() -> None:
    limit = LoginLimit()
    for each in range(MAX_FAILURES):
        fail(limit, f"2001:db8::{each}")
    assert limit.wait("2001:db8::ffff", "anna", "", 1.0) > 0.0
    assert limit.wait("2001:db8:0:1::1", "anna", "", 1.0) == 0.0
    for each in range(MAX_COUNTED + 100):
        fail(limit, f"10.{each // 65536}.{each // 256 % 256}.{each % 256}", name=f"n{each}")
    assert len(limit._addresses) == len(limit._accounts) == MAX_COUNTED


async def test_a_device_does_not_wait_for_others() -> None:
    turns, go_on, order = Turns(), threading.Event(), list[str]()

    def verify(name: str) -> None:
        go_on.wait(30.0)
        order.append(name)

    async with asyncio.TaskGroup() as group:
        for each in range(MAX_LOGINS):
            address = f"10.0.0.{each // MAX_LOGINS_OF_HOST}"
            assert turns.has_room(address, trusted=False)
            group.create_task(turns.take(lambda: verify("guess"), address, trusted=False))
            await asyncio.sleep(0)
        assert not turns.has_room("10.0.0.99", trusted=False), "all places are taken"
        assert turns.has_room("10.0.0.0", trusted=True)
        group.create_task(turns.take(lambda: verify("device"), "10.0.0.0", trusted=True))
        await asyncio.sleep(0)
        go_on.set()
    assert order[:2] == ["guess", "device"]
    assert len(order) == MAX_LOGINS + 1
    assert turns.has_room("10.0.0.0", trusted=False)


async def test_one_host_does_not_take_all_places() -> None:
    turns, go_on = Turns(), threading.Event()
    async with asyncio.TaskGroup() as group:
        for _ in range(MAX_LOGINS_OF_HOST):
            group.create_task(turns.take(lambda: go_on.wait(30.0), "10.0.0.1", trusted=False))
        await asyncio.sleep(0)
        assert not turns.has_room("10.0.0.1", trusted=False)
        assert turns.has_room("10.0.0.2", trusted=False)
        go_on.set()
