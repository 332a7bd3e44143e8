"""Address books in three formats."""

from pathlib import Path

import pytest

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.node import NodeConfig, address_books
from jauspy.protocol.addressing import SerialPort, TcpPort, UdpPort

TOML = """
[addresses]
"101.1.255" = "udp://10.0.0.5:4000"
"102.1.1" = ["10.0.0.6:3794", "tcp://robot", "udp://[fd00::1]"]
"103.1.1" = "serial:/dev/ttyS0"
"""
XML = """<?xml version="1.0" encoding="UTF-8"?>
<JrXmlConfig>
  <UDP_Configuration UDP_Port="3794"/>
  <AddressBook J8257803="10.0.0.5:3794" J8257812="10.0.0.6:4000"/>
</JrXmlConfig>
"""
YAML = """
addrbook:
  udp:
    10.0.0.5:3794: 1.255.255
    10.0.0.6:3794: [1.1.15, 1.1.13]
  tcp:
    {":value": {"10.0.0.7:3794": {":value": [1.1.15]}}}
"""


def load(folder: Path, name: str, text: str) -> address_books.AddressEntries:
    path = folder / name
    path.write_text(text)
    return address_books.load_address_book(path)


def test_jauspy_toml_is_read(tmp_path: Path) -> None:
    assert load(tmp_path, "book.toml", TOML) == {
        JausID(101, 1, 255): (UdpPort("10.0.0.5", 4000),),
        JausID(102, 1, 1): (UdpPort("10.0.0.6", 3794), TcpPort("robot", 3794), UdpPort("fd00::1", 3794)),
        JausID(103, 1, 1): (SerialPort("/dev/ttyS0"),),
    }


def test_toolset_xml_is_read(tmp_path: Path) -> None:
    assert load(tmp_path, "nm.cfg", XML) == {
        JausID(126, 1, 11): (UdpPort("10.0.0.5", 3794),),
        JausID(126, 1, 20): (UdpPort("10.0.0.6", 4000),),
    }
    assert load(tmp_path, "empty.cfg", "<JrXmlConfig/>") == {}


def test_fkie_yaml_is_read(tmp_path: Path) -> None:
    assert load(tmp_path, "iop.yaml", YAML) == {
        JausID(1, 255, 255): (UdpPort("10.0.0.5", 3794),),
        JausID(1, 1, 15): (UdpPort("10.0.0.6", 3794), TcpPort("10.0.0.7", 3794)),
        JausID(1, 1, 13): (UdpPort("10.0.0.6", 3794),),
    }
    assert load(tmp_path, "plain.yaml", "addrbook: {udp: {}, tcp: {}}") == {}


@pytest.mark.parametrize(
    ("name", "text", "reported"),
    [
        ("a.json", "{}", "use one of .toml"),
        ("a.toml", "x = ", "a.toml"),
        ("a.toml", "", r"no table \[addresses\]"),
        ("a.toml", '[addresses]\n"1.1" = "10.0.0.1:1"', "is not a JAUS id"),
        ("a.toml", '[addresses]\n"1.1.1" = 5', "1.1.1 = 5: write udp://"),
        ("a.toml", '[addresses]\n"1.1.1" = "10.0.0.1:99999"', "is not an address"),
        ("a.toml", '[addresses]\n"1.1.1" = "ftp://10.0.0.1"', "is not an address"),
        ("a.toml", '[addresses]\n"1.1.1" = "serial:ttyS0"', "names no device"),
        ("a.cfg", "<JrXmlConfig>", "a.cfg"),
        ("a.cfg", '<X><AddressBook J99999999999="h:1"/></X>', "J and the id in decimal"),
        ("a.cfg", '<!DOCTYPE x [<!ENTITY e SYSTEM "/etc/passwd">]><X><AddressBook J1="&e;"/></X>', "a.cfg"),
        ("a.yaml", "transport: {}", "no key 'addrbook'"),
        ("a.yaml", "addrbook: {sctp: {}}", "only udp and tcp"),
        ("a.yaml", "addrbook: {udp: {x: [}", "a.yaml"),
        ("a.yaml", "addrbook: {udp: [1, 2]}", "addrbook/udp = .*write lines such as"),
        ("a.yaml", "addrbook: {tcp: hello}", "addrbook/tcp = 'hello'"),
        ("a.toml", '[addresses]\n"1.1.1" = "udp://robot.local:3794"', "write the IP address"),
        ("a.cfg", f'<X><AddressBook J{"9" * 5000}="10.0.0.5:1"/></X>', "J and the id in decimal"),
    ],
)
def test_mistakes_name_the_file_and_the_form(tmp_path: Path, name: str, text: str, reported: str) -> None:
    with pytest.raises(ConfigError, match=f"address book .*{reported}"):
        load(tmp_path, name, text)


def test_missing_file_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="No such file"):
        address_books.load_address_book(tmp_path / "nowhere.toml")


def test_settings_and_files_are_combined(tmp_path: Path) -> None:
    (tmp_path / "nm.cfg").write_text(XML)
    config = NodeConfig.make(addresses={"126.1.11": "10.0.0.9:1"}, address_books=(tmp_path / "nm.cfg",))
    assert config.known_addresses()[JausID(126, 1, 11)] == (UdpPort("10.0.0.9", 1), UdpPort("10.0.0.5", 3794))
    with pytest.raises(ConfigError, match="is not an address"):
        NodeConfig.make(addresses={"126.1.11": "nonsense:port"})


def test_a_date_that_is_none_is_told(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match=r"address book .*book\.yaml: month must be in 1\.\.12"):
        load(tmp_path, "book.yaml", "addrbook: 2001-99-99\n")
