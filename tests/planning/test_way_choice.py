"""When another way is taken: not for the noise of one scan, and at once where it is hardly dearer."""

from jauspy.planning.way_choice import WayChoice


def test_a_way_around_a_thing_is_taken_at_once():
    choice = WayChoice()
    choice.look(is_free=False, now=0.0)
    assert choice.takes_around(cost=5.5, left=4.0)


def test_a_way_through_another_door_is_taken_when_the_present_one_stays_blocked():
    choice = WayChoice()
    for number in range(10):
        choice.look(is_free=False, now=0.1 * number)
        assert not choice.takes_around(cost=12.0, left=4.0)
    choice.look(is_free=False, now=1.01)
    assert choice.is_blocked
    assert choice.takes_around(cost=12.0, left=4.0)


def test_a_door_that_opens_and_closes_with_the_noise_of_scans_is_kept():
    choice = WayChoice()
    for number in range(1000):
        choice.look(is_free=bool(number % 2), now=0.1 * number)
        assert not choice.is_blocked
        assert not choice.takes_around(cost=12.0, left=4.0)


def test_a_door_that_is_closed_more_often_than_open_is_given_up():
    choice = WayChoice()
    for number in range(60):
        choice.look(is_free=number % 3 == 0, now=0.1 * number)
    assert choice.is_blocked
    choice.begin()
    assert not choice.is_blocked


def test_two_ways_that_cost_about_the_same_are_not_exchanged():
    choice = WayChoice()
    assert not choice.takes_better(cost=9.0, left=10.0)
    assert choice.takes_better(cost=8.0, left=10.0)
