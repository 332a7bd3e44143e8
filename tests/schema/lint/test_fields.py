"""The linter's rules about fields: each finds its mistake in the line marked `here`, and nothing in what is right."""

from __future__ import annotations

import pytest

HERE = "<!-- here -->"
U8 = 'field_type_unsigned="unsigned byte"'
BYTE = '<fixed_field name="N" field_type="unsigned byte" field_units="one"/>'
RECORD = f'<record name="R">{BYTE}</record>'


def record(inner: str) -> str:
    return f'<record name="Rec">\n{inner}\n</record>'


def field(name: str, optional: bool = False) -> str:
    return f'<fixed_field name="{name}" field_type="byte" field_units="one" optional="{str(optional).lower()}"/>'


def number(inner: str, kind: str = "unsigned byte") -> str:
    return record(f'<fixed_field name="F" field_type="{kind}" field_units="one">\n{inner}\n</fixed_field>')


def bits(*ranges: tuple[int, int], here: int | None = None) -> str:
    parts = "\n".join(
        f'<sub_field name="S{n}">{HERE if n == here else ""}<bit_range from_index="{a}" to_index="{b}"/></sub_field>'
        for n, (a, b) in enumerate(ranges)
    )
    return record(f'<bit_field name="B" {U8}>\n{parts}\n</bit_field>')


def optionals(count: int, here: str = "") -> str:
    fields = "".join(
        f'<fixed_field name="F{n}" field_type="byte" field_units="one" optional="true"/>' for n in range(count)
    )
    return record(f"<presence_vector {U8}/>{here}\n{fields}")


def scale(low: str, high: str, here: str = "", kind: str = "unsigned byte") -> str:
    limits = f'real_lower_limit="{low}" real_upper_limit="{high}"'
    return number(f'<scale_range {limits} integer_function="round"/>{here}', kind)


def nested(depth: int, here: str = "") -> str:
    inner = RECORD
    for _ in range(depth):
        inner = f'<list name="L"><count_field {U8} {GOOD_COUNT}/>{inner}</list>'
    return f"{here}{inner}"


def values(inner: str, here: str = "", kind: str = "unsigned byte") -> str:
    return number(f"<value_set>{here}\n{inner}\n</value_set>", kind)


def span(low: float, high: float, here: str = "") -> str:
    return (
        f'<value_range lower_limit="{low}" lower_limit_type="inclusive" upper_limit="{high}" '
        f'upper_limit_type="inclusive"/>{here}'
    )


def enum(value: int, name: str, here: str = "") -> str:
    return f'<value_enum enum_index="{value}" enum_const="{name}"/>{here}'


def choices(first: int, second: int, here: str = "") -> str:
    def one(index: int) -> str:
        return f'<type_and_units_enum index="{index}" field_type="byte" field_units="one"/>'

    inner = f"{one(first)}\n{one(second)}{here}"
    return record(f'<variable_field name="V"><type_and_units_field>\n{inner}\n</type_and_units_field></variable_field>')


def repeated(count: str, element: str = RECORD, here: str = "", list_here: str = "") -> str:
    return f'<list name="L">{list_here}\n<count_field {U8} {count}/>{here}\n{element}</list>'


def variant(limits: str, here: str = "") -> str:
    second = RECORD.replace('"R"', '"Q"')
    return f'<variant name="V">\n<vtag_field {U8} {limits}/>{here}\n{RECORD}{second}</variant>'


GOOD_COUNT = 'min_count="0" max_count="9"'

RULES = {
    "presence-vector": (
        optionals(9, HERE),
        optionals(8),
        "presence vector of 'Rec' has 8 bits for 9 optional members: 'F8' can never be sent; use a larger type",
    ),
    "bit-overlap": (
        bits((0, 3), (3, 5), here=1),
        bits((0, 3), (4, 5)),
        "'S1' and 'S0' share bit 3; move one of them",
    ),
    "bit-range": (
        bits((0, 3), (4, 8), here=1),
        bits((0, 3), (4, 7)),
        "'S1' has bits 4..8, but 'B' has only bits 0..7; move it or use a larger type",
    ),
    "missing-count": (
        repeated("", here=HERE),
        repeated(GOOD_COUNT),
        "count of 'L' has no min_count and no max_count, so up to 255 are allowed; set the limits",
    ),
    "count-limits": (
        repeated('min_count="5" max_count="256"', here=HERE),
        repeated('min_count="5" max_count="255"'),
        "count_field of 'L': limits 5..256 do not fit 0..255; correct them or take another type",
    ),
    "tag-limits": (
        variant('min_count="0" max_count="2"', HERE),
        variant('min_count="0" max_count="1"'),
        "tag of 'V' allows 0..2, but its 2 arms are 0..1; write",
    ),
    "scale-limits": (scale("2", "1", HERE), scale("1", "2"), "scale of 'F' goes from 2 to 1; swap them"),
    "scale-type": (
        scale("0", "1", HERE, "float"),
        scale("0", "1", kind="unsigned integer"),
        "scale of 'F' means nothing, it is a float; write a value_set",
    ),
    "value-range": (values(span(2, 1, HERE)), values(span(1, 2)), "range of 'F' goes from 2 to 1; swap them"),
    "value-set": (
        values(f"{enum(256, 'BIG')}\n{span(0, 1)}", HERE),
        values(f"{enum(255, 'BIG')}\n{span(0, 1)}"),
        "'F': BIG = 256 is outside 0..255, which is all its type can carry",
    ),
    "duplicate-value": (
        values(f"{enum(1, 'A')}\n{enum(1, 'B', HERE)}"),
        values(f"{enum(1, 'A')}\n{enum(2, 'B')}"),
        "'A' and 'B' of 'F' both stand for 1; keep one",
    ),
    "duplicate-index": (choices(1, 1, HERE), choices(1, 2), "'V' has two alternatives with index 1"),
    "python-name": (
        record(f"{BYTE}\n{field('n')}{HERE}"),
        record(f"{BYTE}\n{field('M')}"),
        "'n' and 'N' in 'Rec' are both n in Python; one gets a number, rename it",
    ),
    "duplicate-name": (
        record(f"{BYTE}\n{field('N')}{HERE}"),
        record(f"{BYTE}\n{field('M')}"),
        "'Rec' has two members called 'N'; rename one",
    ),
}


@pytest.mark.parametrize("code", RULES)
def test_mistakes_in_fields_are_found(jsidl, code):
    wrong, _, message = RULES[code]
    jsidl.service(body=wrong)
    found = jsidl.lint(code)
    assert len(found) == 1
    assert message in found[0]


@pytest.mark.parametrize("code", RULES)
def test_valid_fields_have_no_findings(jsidl, code):
    jsidl.service(body=RULES[code][1])
    assert jsidl.lint(code) == []


@pytest.mark.parametrize("kind", ["unsigned long integer", "long integer"])
def test_scales_finer_than_floats(jsidl, kind):
    jsidl.service(body=scale("-1e6", "1e6", HERE, kind))
    [message] = jsidl.lint("scale-type")
    assert "steps of 'F' are finer than those of a float" in message


def test_too_many_nested_lists_are_found(jsidl):
    messages = [jsidl.message(nested(depth), name=f"M{depth}", code=f"00{depth}") for depth in (16, 17)]
    jsidl.service(messages="\n".join([messages[0], messages[1].replace(">\n", f">{HERE}\n", 1)]))
    assert jsidl.lint("no-code") == [
        "message M17: 'L' has more than 16 lists and arrays one inside the other; flatten it"
    ]


def test_unbounded_list(jsidl):
    """A list's count costs bytes, a presence vector does, an array of strings does: only nothing costs nothing."""
    nothing = '<variant name="V"><vtag_field field_type_unsigned="unsigned byte"/></variant>'
    for number, inner in enumerate(
        (RECORD, f'<record name="O"><presence_vector {U8}/>{field("F", True)}</record>', nothing)
    ):
        jsidl.service(name=f"T{number}", urn=f"urn:test:T{number}", body=repeated(GOOD_COUNT, inner))
    assert jsidl.lint("unbounded-list") == []


def test_an_optional_member_without_a_presence_vector(jsidl):
    jsidl.service(body=f'<record name="Rec">\n{field("N", True)}{HERE}\n{field("M", True)}{HERE}</record>')
    first, _ = jsidl.lint("presence-vector")
    assert first == "'N' is optional, but 'Rec' has no <presence_vector>; add one or make it mandatory"


def test_sub_field_values_beyond_its_bits(jsidl):
    def field(top: int, here: str) -> str:
        inner = f'<bit_range from_index="0" to_index="1"/>\n<value_set>{here}\n{span(0, top)}</value_set>'
        return record(f'<bit_field name="B" {U8}><sub_field name="S">{inner}</sub_field></bit_field>')

    jsidl.service(body=field(4, HERE))
    [message] = jsidl.lint("value-set")
    assert "'S': the range 0..4 is outside 0..3" in message


def test_values_of_signed_and_float_types(jsidl):
    jsidl.service(body=values(span(-128, 127), kind="byte"))
    jsidl.service(name="B", urn="urn:test:B", body=values(span(-1e30, 1e30), kind="float"))
    assert jsidl.lint("value-set") == []


def test_names_of_values_and_messages_that_collide(jsidl):
    second = jsidl.message("", name="msg", code="1235").replace(">\n", f">{HERE}\n", 1)
    first = jsidl.message(values(f"{enum(1, 'ON OFF')}\n{enum(2, 'ON_OFF', HERE)}"))
    jsidl.service(messages=f"{first}\n{second}")
    found = jsidl.lint("python-name")
    assert "are both ON_OFF in Python" in found[0]
    assert "'msg' and 'Msg' in service 'Test' are both msg in Python" in found[1]


@pytest.mark.parametrize(
    ("unit", "problem"),
    [
        ("metre", "'metre', the unit of 'F', is not one of JSIDL; did you mean meter"),
        ("m/s", "'m/s', the unit of 'F', is not one of JSIDL"),
        ("meter per", "'meter per', the unit of 'F', is not one of JSIDL"),
        ("meter", ""),
        ("newton meter", ""),
        ("meter per second squared", ""),
        ("kilogram per cubic meter", ""),
        ("degree Celsius", ""),
        ("rotations per minute", ""),
    ],
)
def test_units(jsidl, unit, problem):
    field = f'<fixed_field name="F" field_type="byte" field_units="{unit}"/>{HERE if problem else ""}'
    jsidl.service(body=record(field))
    found = jsidl.lint("unknown-unit")
    assert [text.startswith(problem) for text in found] == ([True] if problem else [])
