"""Every error says file, line and what was expected. The line with the mistake is marked `here`."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from jauspy.errors import SchemaError
from jauspy.schema import load_files
from jauspy.schema.loader import MAX_FILE_SIZE

U8 = 'field_type_unsigned="unsigned byte"'
HERE = "<!-- here -->"
RECORD = '<record name="R"><fixed_field name="N" field_type="byte" field_units="one"/></record>'
MACHINE = '<state_machine name="M"><state name="A"/></state_machine>'
BYTE = '<fixed_field name="N" field_type="byte" field_units="one"/>'

BODIES = {
    "unknown element": (f"<recrd name='R'/>{HERE}", "unexpected <recrd> in <body>; did you mean record"),
    "unknown attribute": (f'<record nam="R">{HERE}\n{BYTE}</record>', "unknown attribute 'nam'; did you mean name"),
    "missing attribute": (f"<record>{HERE}\n{BYTE}</record>", "<record> needs the attribute 'name'"),
    "two bodies": (
        f'<record name="R">{BYTE}</record>\n<record name="Q">{HERE}{BYTE}</record>',
        "<body> has more than 1 of",
    ),
    "list without count": (
        f'<list name="L">{HERE}\n{RECORD}</list>',
        "<list> needs <count_field>",
    ),
    "list without element": (f'<list name="L">{HERE}\n<count_field {U8}/></list>', "<list> needs <record> or"),
    "variant without tag": (
        f'<variant name="V">{HERE}\n<record name="R">{BYTE}</record></variant>',
        "<variant> needs <vtag_field>",
    ),
    "no such type": (
        f'<record name="R">\n<fixed_field name="N" field_type="int" field_units="one"/>{HERE}</record>',
        "field_type: expected one of 'unsigned byte', .* got 'int'",
    ),
    "signed count": (
        f'<list name="L">\n<count_field field_type_unsigned="byte"/>{HERE}\n{RECORD}</list>',
        "field_type_unsigned: expected one of .* got 'byte'",
    ),
    "count limits": (
        f'<list name="L">\n<count_field {U8} min_count="1" max_count="256"/>{HERE}\n{RECORD}</list>',
        "expected 0 <= min_count <= max_count <= 255, got 1 and 256",
    ),
    "count is no number": (
        f'<list name="L">\n<count_field {U8} min_count="one"/>{HERE}\n{RECORD}</list>',
        "no constant 'one'; there are none",
    ),
    "count is no whole number": (
        f'<list name="L">\n<count_field {U8} max_count="2.5"/>{HERE}\n{RECORD}</list>',
        "max_count: expected a whole number, got '2.5'",
    ),
    "not a boolean": (f'<record name="R" optional="yes">{HERE}\n{BYTE}</record>', "optional: expected one of 'true'"),
    "scale upside down": (
        (
            '<record name="R"><fixed_field name="N" field_type="byte" field_units="one">\n'
            f'<scale_range real_lower_limit="2" real_upper_limit="1" integer_function="round"/>{HERE}'
            "</fixed_field></record>"
        ),
        "expected real_lower_limit < real_upper_limit, got 2.0 and 1.0",
    ),
    "scale is no number": (
        (
            '<record name="R"><fixed_field name="N" field_type="byte" field_units="one">\n'
            f'<scale_range real_lower_limit="a b" real_upper_limit="1" integer_function="round"/>{HERE}'
            "</fixed_field></record>"
        ),
        "real_lower_limit: expected a number or a constant expression, got 'a b'",
    ),
    "range upside down": (
        (
            '<record name="R"><fixed_field name="N" field_type="byte" field_units="one"><value_set>\n'
            '<value_range lower_limit="2" lower_limit_type="inclusive" '
            f'upper_limit_type="inclusive" upper_limit="1"/>{HERE}'
            "</value_set></fixed_field></record>"
        ),
        "expected lower_limit <= upper_limit",
    ),
    "enum is no number": (
        (
            '<record name="R"><fixed_field name="N" field_type="byte" field_units="one"><value_set>\n'
            f'<value_enum enum_index="x" enum_const="A"/>{HERE}</value_set></fixed_field></record>'
        ),
        "enum_index: expected a whole number, got 'x'",
    ),
    "bits outside": (
        (
            f'<record name="R"><bit_field name="B" {U8}><sub_field name="S">\n'
            f'<bit_range from_index="4" to_index="8"/>{HERE}</sub_field></bit_field></record>'
        ),
        "to_index: expected a whole number from 4 to 7, got 8",
    ),
    "index outside": (
        (
            '<record name="R"><variable_field name="V"><type_and_units_field>\n'
            f'<type_and_units_enum index="256" field_type="byte" field_units="one"/>{HERE}'
            "</type_and_units_field></variable_field></record>"
        ),
        "index: expected a whole number from 0 to 255, got 256",
    ),
    "empty string": (
        f'<record name="R">\n<fixed_length_string name="S" string_length="0"/>{HERE}</record>',
        "string_length: expected 1 to 1048576, got 0",
    ),
    "endless string": (
        f'<record name="R">\n<fixed_length_string name="S" string_length="99999999999"/>{HERE}</record>',
        "string_length: expected 1 to 1048576, got 99999999999",
    ),
    "endless array": (
        f'<record name="R">\n<array name="A">{HERE}{BYTE}<dimension name="d" size="1048577"/></array></record>',
        "array 'A' takes 1048577 bytes; at most 1048576 are allowed",
    ),
    "more arms than tags": (
        f'<variant name="V">{HERE}\n<vtag_field {U8}/>'
        + "".join(RECORD.replace('"R"', f'"R{number}"') for number in range(257))
        + "</variant>",
        "257 arms, but its tag has only 256 values; use a larger type",
    ),
    "values sent as distances": (
        (
            '<record name="R"><fixed_field name="N" field_type="byte" field_units="one">\n'
            f'<value_set offset_to_lower_limit="true">{HERE}<value_enum enum_index="5" enum_const="A"/></value_set>'
            "</fixed_field></record>"
        ),
        "distance from 5 are not supported; set it to false if they are sent as they are",
    ),
    "empty array": (
        f'<record name="R"><array name="A">{BYTE}\n<dimension name="d" size="0"/>{HERE}</array></record>',
        "size: expected at least 1, got 0",
    ),
    "optional without presence vector": (
        (
            f'<record name="R">\n<variable_length_string name="N" optional="true">{HERE}<count_field {U8}/>'
            "</variable_length_string></record>"
        ),
        "'N' is optional, but 'R' has no <presence_vector>",
    ),
    "duplicate field": (f'<record name="R">{BYTE}\n{BYTE}{HERE}</record>', "duplicate name 'N' in 'R'"),
    "duplicate arm": (
        f'<variant name="V"><vtag_field {U8}/>{RECORD}\n<record name="R">{HERE}{BYTE}</record></variant>',
        "duplicate name 'R' in 'V'",
    ),
    "no such declared type": (
        f'<declared_record name="R" declared_type_ref="Pos"/>{HERE}',
        "no declared type 'Pos'; did you mean Pose",
    ),
    "no such type set": (
        f'<declared_record name="R" declared_type_ref="cor.Pose"/>{HERE}',
        "'cor.Pose': no type set is called 'cor' here; there are none",
    ),
    "wrong kind": (
        f'<declared_list name="R" declared_type_ref="Pose"/>{HERE}',
        "'Pose' is a record, but <declared_list> needs a list",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize(("body", "message"), BODIES.values(), ids=BODIES.keys())
def test_wrong_body(jsidl, body, message):
    jsidl.service(body=body, types=f'<record name="Pose" optional="false">{BYTE}</record>')
    error = jsidl.error()
    assert error.line is not None
    assert_matches(error, message)


def assert_matches(error: SchemaError, message: str) -> None:
    assert re.search(message, str(error))


def transition(inner: str) -> str:
    return (
        '<state_machine name="M"><state name="A"><state name="Standby">\n'
        f'<transition name="T">{inner}</transition>\n</state></state></state_machine>'
    )


BEHAVIORS = {
    "transition without kind": (transition(HERE), "<transition> needs <simple> or <internal> or <push> or <pop>"),
    "push without end": (transition(f"\n<push/>{HERE}"), "<push> needs <end_state>"),
    "no such end state": (
        transition(f'<simple>{HERE}<end_state state="A.Stanby"/></simple>'),
        "end state 'A.Stanby': no state 'Stanby'; did you mean Standby",
    ),
    "pop with transition": (transition(f'\n<pop transition="x"/>{HERE}'), "a pop that triggers .* not supported"),
    "push with simple": (
        transition(f'\n<push>{HERE}<end_state state="A"/><simple/></push>'),
        "a push with a second transition is not supported",
    ),
    "duplicate machine": (
        f'{MACHINE}\n<state_machine name="M">{HERE}<state name="A"/></state_machine>',
        "duplicate state_machine 'M'",
    ),
    "duplicate state": (
        f'<state_machine name="M"><state name="A"/>\n<state name="A"/>{HERE}</state_machine>',
        "duplicate state 'A'",
    ),
    "no such machine": (
        f'<start state_machine_name="N" state_name="A"/>{HERE}\n{MACHINE}',
        "no state machine 'N'; known: M",
    ),
    "no such start": (
        f'<start state_machine_name="M" state_name="B"/>{HERE}\n{MACHINE}',
        "start state 'B': no state 'B'; known: A",
    ),
    "no such message": (
        (
            '<state_machine name="M"><state name="A">\n'
            f'<transition name="transport.Receive">{HERE}<parameter type="Mgs" value="msg"/><internal/></transition>'
            "</state></state_machine>"
        ),
        "a transition receives 'Mgs', which is not a message here; did you mean Msg",
    ),
    "guard that nobody can read": (
        (
            '<state_machine name="M"><state name="A">\n'
            f'<transition name="T">{HERE}<guard condition="isReady(msg"/><internal/></transition>'
            "</state></state_machine>"
        ),
        r"guard 'isReady\(msg': expected",
    ),
    "no such initial state": (
        f'<state_machine name="M">\n<state name="A" initial_state="C">{HERE}<state name="B"/></state></state_machine>',
        "initial state 'A.C': no state 'C'; known: B",
    ),
}


@pytest.mark.parametrize(("behavior", "message"), BEHAVIORS.values(), ids=BEHAVIORS.keys())
def test_wrong_behavior(jsidl, behavior, message):
    jsidl.service(behavior=behavior)
    assert_matches(jsidl.error(), message)


def test_message_id(jsidl):
    jsidl.service(messages=jsidl.message("", code="12345").replace(">\n", f">{HERE}\n", 1))
    assert_matches(jsidl.error(), "message_id: expected four hexadecimal digits, got '12345'")


def test_duplicate_message_id(jsidl):
    second = jsidl.message("", name="Second").replace(">\n", f">{HERE}\n", 1)
    jsidl.service(messages=jsidl.message("") + "\n" + second)
    assert_matches(jsidl.error(), "duplicate message_id '1234'; the first is in line 11")


def test_duplicate_message_id_with_other_content(jsidl):
    first = jsidl.message(f'<record name="R" optional="false">{BYTE}</record>')
    second = jsidl.message(f'<record name="Q" optional="false">{BYTE}</record>', name="Second")
    jsidl.service(messages=first + "\n" + second.replace(">\n", f">{HERE}\n", 1))
    assert_matches(jsidl.error(), "duplicate message_id '1234'; the first is in line 11")


def test_duplicate_message_name(jsidl):
    second = jsidl.message("", code="1235").replace(">\n", f">{HERE}\n", 1)
    jsidl.service(messages=jsidl.message("") + "\n" + second)
    assert_matches(jsidl.error(), "duplicate name 'Msg'")


def test_one_code_with_two_meanings(jsidl):
    path = jsidl.service(outputs=jsidl.message(f'<record name="R">{BYTE}</record>', name="Other"))
    error = jsidl.error()
    assert (error.file, error.line) == (str(path), 1)
    assert_matches(error, "message_id '1234' has two meanings: Msg and Other")


def test_header_that_is_not_a_message_id(jsidl):
    wrong = (
        jsidl.message("").replace("unsigned short integer", "unsigned integer").replace("</header>", f"</header>{HERE}")
    )
    jsidl.service(messages=wrong)
    assert_matches(jsidl.error(), "the header must be a record with the message id")


def test_footer_with_content(jsidl):
    footer = f'<footer name="F">{HERE}<record name="R">{BYTE}</record></footer>'
    jsidl.service(messages=jsidl.message("").replace('<footer name="F"/>', footer))
    assert_matches(jsidl.error(), "a footer with content is not supported")


def test_duplicate_event(jsidl):
    event = '<event_def name="E"><header name="H"/><body name="B"/><footer name="F"/></event_def>'
    jsidl.service(events=f"{event}\n{event}{HERE}")
    assert_matches(jsidl.error(), "duplicate name 'E'")


def test_duplicate_type(jsidl):
    record = f'<record name="R" optional="false">{BYTE}</record>'
    jsidl.service(types=f"{record}\n{record}{HERE}")
    assert_matches(jsidl.error(), "duplicate name 'R'; the first is at .*:7")


def test_type_in_itself(jsidl):
    jsidl.service(
        types=f"""<list name="A"><count_field {U8}/><declared_list name="x" declared_type_ref="B"/></list>
<list name="B"><count_field {U8}/>
<declared_list name="x" declared_type_ref="A"/>{HERE}
</list>"""
    )
    assert_matches(jsidl.error(), "'A' contains itself")


def test_constant_in_itself(jsidl):
    jsidl.service(
        body='<record name="R">\n<fixed_length_string name="S" string_length="A"/></record>',
        consts="""<declared_const_set name="c">
<const_def name="A" const_type="byte" field_units="one" const_value="B"/>
<const_def name="B" const_type="byte" field_units="one" const_value="A"/></declared_const_set>""",
    )
    assert_matches(jsidl.error(), "'const A' contains itself")


def test_types_nested_too_deeply(jsidl):
    chain = "\n".join(
        f'<list name="L{i}"><count_field {U8}/><declared_list name="x" declared_type_ref="L{i + 1}"/></list>'
        for i in range(2000)
    )
    jsidl.service(types=f'{chain}\n<list name="L2000"><count_field {U8}/>{RECORD}</list>')
    assert_matches(jsidl.error(), "refers to declared types too deeply")


def test_error_in_an_unused_type(jsidl):
    jsidl.service(types=f'<declared_record name="R" declared_type_ref="Gone"/>{HERE}')
    assert_matches(jsidl.error(), "no declared type 'Gone'")


def test_type_set_that_is_not_loaded(jsidl):
    jsidl.service(types=f'<declared_type_set_ref name="t" id="urn:t" version="1.0"/>{HERE}')
    assert_matches(
        jsidl.error(),
        "no declared_type_set urn:t 1.0 is loaded; there are none; give its file, too, or the folder of its set, urn",
    )


def test_parent_that_is_not_loaded(jsidl):
    jsidl.service(
        references=f'<references>\n<inherits_from name="p" id="urn:test:Tset" version="1.0"/>{HERE}</references>'
    )
    assert_matches(
        jsidl.error(),
        r"no service urn:test:Tset 1.0 is loaded; did you mean urn:test:Test 1.0\?; give its file, too, or the folder",
    )


def test_parent_of_another_version(jsidl):
    jsidl.service(name="Parent", urn="urn:p", version="2.0")
    jsidl.service(references=f'<references>\n<inherits_from name="p" id="urn:p" version="1.*"/>{HERE}</references>')
    assert_matches(jsidl.error(), "no service urn:p 1.* is loaded")


def test_service_that_inherits_from_itself(jsidl):
    jsidl.service(references='<references><inherits_from name="p" id="urn:test:Test" version="1.0"/></references>')
    assert_matches(jsidl.error(), "urn:test:Test inherits from itself")


def test_version(jsidl):
    path = jsidl.service(version="1")
    assert jsidl.error().file == str(path)


def test_two_definitions_of_one_service(jsidl):
    path = jsidl.service()
    other = jsidl.file("other.xml", path.read_text().replace("1234", "1235"))
    error = jsidl.error()
    assert (error.file, error.line) == (str(other), 1)
    assert_matches(error, f"urn:test:Test 1.0 is defined differently at {path}:1")


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        ("", 1, "not well-formed XML"),
        ("<a>\n<b>\n</a>", 3, "not well-formed XML"),
        ("<service_def/>", 1, "expected a JSIDL document"),
        ('<record xmlns="urn:jaus:jsidl:1.1"/>', 1, "as the root, got <record>"),
        ('<service_def xmlns="urn:jaus:jsidl:1.1">\n<x xmlns="urn:other"/></service_def>', 2, "in no JSIDL namespace"),
    ],
)
def test_not_jsidl(jsidl, text, line, message):
    path = jsidl.file("a b&ü.xml", text)
    error = jsidl.error()
    assert (error.file, error.line) == (str(path), line)
    assert_matches(error, message)


def test_no_such_file(tmp_path: Path):
    with pytest.raises(SchemaError, match="cannot be read: No such file") as caught:
        load_files([tmp_path / "gone.xml"])
    assert caught.value.file == str(tmp_path / "gone.xml")


def test_file_too_large(jsidl):
    jsidl.file("large.xml", " " * (MAX_FILE_SIZE + 1))
    assert_matches(jsidl.error(), f"larger than {MAX_FILE_SIZE} bytes")
