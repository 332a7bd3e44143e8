"""The linter's rules about references and structure. What is wrong is in the lines marked `here`."""

from __future__ import annotations

HERE = "<!-- here -->"
U8 = 'field_type_unsigned="unsigned byte"'
BYTE = '<fixed_field name="N" field_type="unsigned byte" field_units="one"/>'
CORE = '<declared_type_set_ref name="core" id="urn:jauspy:core:Types" version="1.0"/>'


def use(name: str, here: str = "", kind: str = "record") -> str:
    return f'<declared_{kind} name="Use" declared_type_ref="{name}" optional="false"/>{here}'


def type_record(name: str) -> str:
    return f'<record name="{name}" optional="false">{BYTE}</record>'


def test_all_dangling_references_are_found_in_one_run(jsidl):
    messages = "\n".join(
        jsidl.message(use(name, HERE), name=f"M{n}", code=f"100{n}") for n, name in enumerate(("Gone", "Pos", "a.b.C"))
    )
    jsidl.service(messages=messages, types=type_record("Pose"))
    found = jsidl.lint("dangling-reference")
    assert found[0].startswith("no declared type 'Gone'")
    assert found[1] == "no declared type 'Pos'; did you mean Pose" + "?"
    assert "no type set is called 'a' here" in found[2]


def test_valid_references_have_no_findings(jsidl):
    jsidl.service(body=use("Pose"), types=type_record("Pose"))
    jsidl.service(
        name="Far",
        urn="urn:test:Far",
        types=CORE,
        body=f'<record name="R">{use("core.Priority", kind="fixed_field")}</record>',
    )
    assert jsidl.lint("dangling-reference") == []
    assert jsidl.lint("dangling-set") == []


def test_missing_set_is_one_finding(jsidl):
    reference = f'<declared_type_set_ref name="far" id="urn:test:Gone" version="1.0"/>{HERE}'
    messages = "\n".join(jsidl.message(use("far.T"), name=f"M{n}", code=f"100{n}") for n in range(3))
    jsidl.service(messages=messages, types=reference)
    [message] = jsidl.lint("dangling-set")
    assert message.startswith("no declared_type_set urn:test:Gone 1.0 is loaded")
    assert message.endswith("the folder of its set, test (3 references go through 'far')")


def test_a_reference_of_the_wrong_kind(jsidl):
    jsidl.service(body=use("Pose", HERE, "list"), types=type_record("Pose"))
    assert jsidl.lint("dangling-reference") == ["'Pose' is a record, but <declared_list> needs a list"]


def string(length: str, here: str = "") -> str:
    return f'<record name="R">\n<fixed_length_string name="S" string_length="{length}"/>{here}</record>'


def test_dangling_constants(jsidl):
    consts = (
        '<declared_const_set name="c"><const_def name="SIZE" const_type="byte" const_value="3"/></declared_const_set>'
    )
    jsidl.service(body=string("SIZ * 2", HERE), consts=consts)
    jsidl.service(name="B", urn="urn:test:B", body=string("SIZE * 2"), consts=consts)
    assert jsidl.lint("dangling-constant") == ["no constant 'SIZ'; did you mean SIZE?"]


def parent(urn: str, here: str = "") -> str:
    return f'<references>\n<inherits_from name="p" id="{urn}" version="1.0"/>{here}\n</references>'


def test_missing_parent(jsidl):
    jsidl.service(references=parent("urn:test:Gone", HERE))
    [message] = jsidl.lint("missing-parent")
    assert message.startswith("inherits_from: no service urn:test:Gone 1.0 is loaded")


def test_built_in_and_given_parents_are_found(jsidl):
    jsidl.service(references=parent("urn:jaus:jss:core:Events").replace("1.0", "1.*"))
    jsidl.service(name="Child", urn="urn:test:Child", references=parent("urn:test:Test"))
    assert jsidl.lint("missing-parent") == []


def test_cyclic_parents_are_found(jsidl):
    jsidl.service(references=parent("urn:test:B", HERE))
    jsidl.service(name="B", urn="urn:test:B", references=parent("urn:test:Test", HERE))
    assert all("inherits from itself; cut the circle" in message for message in jsidl.lint("missing-parent"))


def test_all_grammar_mistakes_are_found(jsidl):
    unknown = f'<recrd name="R">{HERE}\n<what/></recrd>'
    body = f'{unknown}\n<record nam="R">{HERE}\n{BYTE}\n<fixed_field name="F"/>{HERE}</record>'
    jsidl.service(body=body)
    found = jsidl.lint("grammar")
    assert "unexpected <recrd> in <body>; did you mean record or declared_record?" in found
    assert "<record> has an unknown attribute 'nam'; did you mean name?" in found
    assert "<fixed_field> needs the attribute 'field_units'" in found


def test_duplicate_names_in_a_set(jsidl):
    jsidl.service(types=f"{type_record('T')}\n{type_record('T')}{HERE}")
    [message] = jsidl.lint("duplicate-definition")
    assert message.startswith("duplicate name 'T'; the first is at")


def test_one_id_for_two_definitions(jsidl):
    text = jsidl.service(types=type_record("T")).read_text()
    jsidl.file("other.xml", text.replace('version="1.0">', f'version="1.0">{HERE}').replace('"T"', '"S"'))
    [message] = jsidl.lint("duplicate-definition")
    assert message.startswith("urn:test:Test 1.0 is defined differently at")


def test_identical_definitions_are_no_finding(jsidl):
    path = jsidl.service(types=type_record("T"))
    jsidl.file("copy.xml", path.read_text())
    assert jsidl.lint("duplicate-definition") == []
