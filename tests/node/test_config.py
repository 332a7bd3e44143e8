"""The configuration file: complete when printed, exact when wrong."""

from pathlib import Path

import pytest
from pydantic import BaseModel

from jauspy.errors import ConfigError
from jauspy.node import NodeConfig, config as policy
from jauspy.node.config import GatewayConfig, NetworkConfig, RuleConfig, load_config, to_toml

GATEWAY = """
address = "10.0.0.1"
[[networks]]
name = "vehicle"
address = "10.1.0.1"
[gateway]
subsystem = 101
inside = ["vehicle"]
[[gateway.rules]]
source = "42.*.*"
messages = [0x0405, "QueryStatus", "0x2000-0x20FF"]
rate = 5
"""


@pytest.fixture
def written(tmp_path: Path) -> Path:
    return tmp_path / "nm.toml"


LIMITS = """
address = "10.0.0.1"
limit = { "all" = "250 kbit/s", "ReportLocalPose" = "5/s" }
[[networks]]
name = "radio"
address = "10.1.0.1"
limit = { "0x4A00-0x4AFF" = "20 kbit/s" }
[[serial]]
device = "/dev/ttyS0"
limit = { "all" = "9600 bit/s" }
"""
SERVICES = 'local_mode = 0o600\nmetrics = "127.0.0.1:9794"\nlog = "json"\n'


@pytest.mark.parametrize("text", ["", GATEWAY, LIMITS, SERVICES])
def test_printed_configuration_reads_back_equal(written: Path, text: str) -> None:
    written.write_text(text)
    config = load_config(written)
    written.write_text(to_toml(config))
    assert load_config(written) == config


@pytest.mark.parametrize("model", [NodeConfig, NetworkConfig, GatewayConfig, RuleConfig])
def test_all_settings_have_a_comment_and_unset_ones_an_example(model: type[BaseModel]) -> None:
    for name, field in model.model_fields.items():
        assert field.description, name
        assert field.default is not None or field.examples, name


def test_the_examples_in_comments_are_valid(written: Path) -> None:
    printed = to_toml(NodeConfig()).splitlines()
    settings = [line for line in printed if not line.startswith("# ") or line[2:].split(" = ")[0].isidentifier()]
    plain = [line.removeprefix("# ") for line in printed if line in settings or line.startswith("# [")]
    written.write_text("\n".join(plain).replace('"0.0.0.0"', '"10.0.0.1"'))
    config = load_config(written)
    assert config.gateway is not None
    assert policy.make_gateway(config) is not None
    assert config.metrics == "127.0.0.1:9794"


def test_options_override_the_file(written: Path) -> None:
    written.write_text("port = 5000\nmulticast_ttl = 3\n")
    config = load_config(written, {"port": 6000, "address": None})
    assert (config.port, config.multicast_ttl, config.address) == (6000, 3, "0.0.0.0")


@pytest.mark.parametrize(
    ("text", "reported"),
    [
        ("port = 70000", "port = 70000: input should be less than or equal to 65535"),
        ("prot = 1", "prot = 1: there is no such key; known here are: address, address6, address_books,"),
        (
            "[[networks]]\nname = 'b'\nadress = 'x'",
            "networks[0].adress = 'x': there is no such key; known here are: addr",
        ),
        ("[gateway]", "gateway.subsystem: is missing"),
        ("[gateway]\nsubsystem = 1\ninside = ['in']", "gateway: there is no network 'in'; known are: lan"),
        (
            "[gateway]\nsubsystem = 1\n[[gateway.rules]]\nsource = '42'",
            "source = '42': write SUBSYSTEM.NODE.COMPONENT wi",
        ),
        ("[gateway]\nsubsystem = 1\n[[gateway.rules]]\nrate = -1", "gateway.rules[0].rate = -1: input should be great"),
        ("[[networks]]\naddress = '10.0.0.1'", "networks: 2 are named 'lan'; give each its own `name`"),
        ("[[networks]]\nname = 'b'\naddress = '10.0.0.1'", "'lan' has all of port 3794; give it an `address`"),
        ("metrics = '9794'", "metrics = '9794': write ADDRESS:PORT, as in 127.0.0.1:9794"),
        ('multicast_group6 = "ff15::1"', "multicast_group6: needs IPv6; set `address6`"),
        ('address6 = "::"\nmulticast_group6 = "fd00::1"', "write an IPv6 multicast address, as in ff15::"),
        ("local_mode = 660", "local_mode = 660: write three octal digits, as in 0o660"),
        ("multicast_interfaces = 'eth0'", "multicast_interfaces = 'eth0': write a list, as in [...]"),
        ("networks = { name = 'b' }", "networks = {'name': 'b'}: write a table [[networks]] for each"),
        ("networks = [5]", "networks[0] = 5: write a table"),
        ("gateway = 5", "gateway = 5: write a table, as in [gateway]"),
        ("addresses = 5", "addresses = 5: write a table, as in [addresses]"),
        ("port = ", "is not TOML"),
    ],
)
def test_mistakes_name_file_key_and_fix(written: Path, text: str, reported: str) -> None:
    written.write_text(text)
    with pytest.raises(ConfigError) as caught:
        load_config(written)
    assert str(caught.value).startswith(f"{written}: is ")
    assert reported in str(caught.value)


def test_missing_file_is_an_error(written: Path) -> None:
    with pytest.raises(ConfigError, match="cannot be read: No such file"):
        load_config(written)


def test_unknown_message_error_has_similar_names(written: Path) -> None:
    written.write_text('[gateway]\nsubsystem = 1\n[[gateway.rules]]\nmessages = ["QueryStatsu"]')
    with pytest.raises(ConfigError, match=r"gateway.rules\[0\].messages: .*QueryStatus.*write its id"):
        policy.make_gateway(load_config(written))
