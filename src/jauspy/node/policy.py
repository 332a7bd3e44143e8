"""From settings to what the core decides by: gateway, rules and limits."""

from __future__ import annotations

from jauspy.errors import ConfigError
from jauspy.messages import registry
from jauspy.node.config import NodeConfig, RuleConfig
from jauspy.node.settings import parse_codes, parse_pattern
from jauspy.protocol.gateway import Gateway, GatewayRule, GatewayRules
from jauspy.protocol.sources import SourceLimits


def limits(config: NodeConfig) -> SourceLimits:
    """What is asked of sources."""
    return SourceLimits(check_address=config.source_check, rate=config.rate_limit, burst=config.rate_burst)


def gateway(config: NodeConfig) -> Gateway | None:
    """The gateway, if there is one; raises `ConfigError` for a message that nobody knows."""
    told = config.gateway
    if told is None:
        return None
    rules = GatewayRules([_rule(number, rule) for number, rule in enumerate(told.rules)], inside=told.inside)
    return Gateway(told.subsystem, [network.name for network in config.all_networks], told.inside, rules)


def _rule(number: int, config: RuleConfig) -> GatewayRule:
    return GatewayRule(
        allow=config.action == "allow",
        source=parse_pattern(config.source),
        destination=parse_pattern(config.destination),
        network=config.network,
        messages=None if config.messages is None else tuple(_codes(number, each) for each in config.messages),
        rate=config.rate,
    )


def _codes(number: int, text: str) -> range:
    codes = parse_codes(text)
    if codes is not None:
        return codes
    try:
        code = registry.by_name(text).CODE
    except ConfigError as error:
        raise ConfigError(f"gateway.rules[{number}].messages: {error}; or write its id, as in 0x2301") from None
    return range(code, code + 1)
