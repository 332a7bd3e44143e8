"""Static and learned addresses: precedence, wildcards, expiry, bounds."""

from jauspy.ids import JausID
from jauspy.protocol.address_book import AddressBook, IdBounds
from jauspy.protocol.addressing import TcpPort, UdpPort

HOME, AWAY, GATE = UdpPort("10.0.0.1", 1), UdpPort("10.0.0.2", 2), UdpPort("10.0.0.3", 3)
ONE = int(JausID(101, 1, 1))


def test_exact_addresses_precede_learned_and_wildcard_ones() -> None:
    book = AddressBook({int(JausID(101, 255, 255)): [GATE], int(JausID(101, 1, 9)): [HOME]})
    assert book.find(ONE, 0.0) == GATE
    assert book.learn(ONE, AWAY, 0.0)
    assert book.find(ONE, 0.0) == AWAY
    assert not book.learn(int(JausID(101, 1, 9)), AWAY, 0.0)
    assert book.find(int(JausID(101, 1, 9)), 0.0) == HOME
    assert book.find(int(JausID(102, 1, 1)), 0.0) is None
    assert book.find(int(JausID(357, 1, 1)), 0.0) is None


def test_learn_returns_true_only_for_changes() -> None:
    book = AddressBook(lifetime=10.0)
    assert [book.learn(ONE, port, now) for port, now in ((HOME, 0), (HOME, 9), (HOME, 18), (AWAY, 18), (AWAY, 28))] == [
        True,
        False,
        False,
        True,
        True,
    ]


def test_udp_and_tcp_on_one_port_are_two_addresses() -> None:
    book = AddressBook()
    book.learn(ONE, UdpPort("10.0.0.1", 3794), 0.0)
    assert book.learn(ONE, TcpPort("10.0.0.1", 3794), 0.0)


def test_least_recently_received_id_is_dropped() -> None:
    book = AddressBook(lifetime=10.0, bounds=IdBounds(3))
    for number in range(5):
        book.learn(number, HOME, float(number))
    assert len(book) == 3
    assert book.find(1, 5.0) is None
    book.learn(9, HOME, 13.5)
    assert len(book) == 2


def test_addresses_of_a_closed_connection_are_removed() -> None:
    book = AddressBook()
    for number in range(4):
        book.learn(number, HOME if number % 2 else AWAY, 0.0)
    book.forget(HOME)
    assert [book.find(number, 0.0) for number in range(4)] == [AWAY, None, AWAY, None]
