"""The linter's rules about message ids and descriptions. What is wrong is in the lines marked `here`."""

from __future__ import annotations

HERE = "<!-- here -->"


def record(kind: str = "unsigned byte", name: str = "R") -> str:
    return f'<record name="{name}"><fixed_field name="N" field_type="{kind}" field_units="one"/></record>'


def marked(message: str) -> str:
    return message.replace(">\n", f">{HERE}\n", 1)


def inherits(urn: str = "urn:test:Test") -> str:
    return f'<references><inherits_from name="p" id="{urn}" version="1.0"/></references>'


def test_duplicate_ids_and_names_in_one_service(jsidl):
    messages = [
        jsidl.message("", name="A", code="1001"),
        marked(jsidl.message("", name="B", code="1001")),
        marked(jsidl.message("", name="A", code="1002")),
        jsidl.message("", name="C", code="1003"),
    ]
    jsidl.service(messages="\n".join(messages))
    assert jsidl.lint("duplicate-message") == [
        "message_id 1001 of B is that of A in line 11; give it another or delete one",
        "name A of A is that of A in line 11; give it another or delete one",
    ]


def test_input_and_output_may_be_the_same_message(jsidl):
    jsidl.service(messages=jsidl.message(record()), outputs=jsidl.message(record(name="Other")))
    assert jsidl.lint("duplicate-message") == []


def test_input_and_output_must_not_differ_under_one_id(jsidl):
    jsidl.service(messages=jsidl.message(record()), outputs=marked(jsidl.message(record("byte"), name="Back")))
    [message] = jsidl.lint("duplicate-message")
    assert message.startswith("message_id 1234 of Back also means Msg (")


def test_derived_service_must_not_change_an_inherited_message(jsidl):
    jsidl.service(body=record())
    jsidl.service(name="Good", urn="urn:test:Good", references=inherits(), body=record(name="Q"))
    messages = marked(jsidl.message(record("byte")))
    jsidl.service(name="Bad", urn="urn:test:Bad", references=inherits(), messages=messages)
    [message] = jsidl.lint("duplicate-message")
    assert "a receiver cannot distinguish them" in message


def test_one_id_in_two_services(jsidl):
    jsidl.service(messages=marked(jsidl.message(record())))
    jsidl.service(name="Other", urn="urn:else:Other", messages=marked(jsidl.message(record("byte"), name="Thing")))
    jsidl.service(name="Same", urn="urn:third:Same", messages=marked(jsidl.message(record())))
    found = jsidl.lint("conflicting-message")
    assert found[0].startswith("message_id 1234 of Thing is also Msg (")
    assert "of urn:test:Test, and of 1 more, with other content" in found[0]
    assert all("is also Thing (" in message for message in found[1:])


def test_one_id_of_a_built_in_message(jsidl):
    jsidl.service(messages=marked(jsidl.message(record("long integer"), name="Mine", code="4002")))
    [message] = jsidl.lint("conflicting-message")
    assert "ReportStatus (" in message


def test_versions_of_a_service_and_of_its_set_may_differ(jsidl):
    jsidl.service(body=record())
    jsidl.service(body=record("byte"), version="1.1")
    jsidl.service(name="Other", urn="urn:test:Other", body=record("integer"), version="2.0")
    assert jsidl.lint("conflicting-message") == []


def test_missing_descriptions(jsidl):
    bad = jsidl.message(record(), name="Bad").replace("<description>d</description>\n", "")
    good = jsidl.message(record(), name="Good", code="1002")
    good = good.replace('name="N"', 'name="N" interpretation="What it is."')
    good = good.replace('name="MessageID"', 'name="MessageID" interpretation="What it is."')
    jsidl.service(messages=f"{marked(bad)}\n{good}")
    assert jsidl.lint("no-description") == [
        "message 'Bad' has no description; describe its purpose",
        "no interpretation of MessageID, N in message 'Bad'; describe their meaning",
    ]
