from __future__ import annotations

from jauspy.schema import load_files, model as m


def test_service(jsidl):
    path = jsidl.service(
        body="",
        references='<references><client_of name="c" id="urn:other" version="1.0"/></references>',
        outputs='<declared_message_def name="Mine" declared_type_ref="Other"/>',
        types=jsidl.message("", name="Other", code="00ff"),
        events='<event_def name="Late"><description>It is late.</description><header name="H"/><body name="Body">'
        '<record name="R"><fixed_field name="N" field_type="byte" field_units="one"/></record></body><footer name="F"/>'
        "</event_def>",
    )
    (service,) = jsidl.load().services
    assert (service.name, service.id, service.version, service.jsidl) == ("Test", "urn:test:Test", "1.0", "1.1")
    assert (service.doc, service.assumptions) == ("d", "a")
    assert service.client_of == (m.Reference("c", "urn:other", "1.0"),)
    message, declared = service.messages
    assert (message.name, message.code, message.is_command, message.body) == ("Msg", 0x1234, True, None)
    assert message.where.file == str(path)
    assert path.read_text().splitlines()[message.where.line - 1].startswith('<message_def name="Msg"')
    assert (declared.name, declared.code) == ("Mine", 0xFF)
    assert declared.declared == m.DeclaredType("urn:test:Test", "1.0", "Other")
    record = m.Record(name="R", fields=(m.FixedField(name="N", type="i8"),))
    assert service.internal_events == (m.InternalEvent(name="Late", body=record, doc="It is late."),)


def test_both_namespaces_in_one_file(jsidl):
    jsidl.service(
        namespace="urn:jaus:jsidl:1.0",
        behavior='<state_machine name="M"><state name="S"><transition name="T">'
        '<x:internal xmlns:x="urn:jaus:jsidl:1.1"/></transition></state></state_machine>',
    )
    (service,) = jsidl.load().services
    assert service.jsidl == "1.0"
    assert service.behavior.machines[0].states[0].transitions[0].kind == "internal"


def test_behavior(jsidl):
    path = jsidl.service(
        behavior="""<start state_machine_name="M" state_name="A.B"/>
<state_machine name="M">
<state name="A" initial_state="B">
<entry><action name="hello"/></entry>
<exit><send_action name="Send"><argument value="'Bye'"/><argument value="who"/></send_action></exit>
<transition name="t.Receive"><parameter type="Msg" value="msg"/><guard condition=" ok( msg )  &amp;&amp;
 x"/><simple><end_state state="A.C"/></simple><action name="go"/></transition>
<default_transition><internal/></default_transition>
<state name="B"><transition name="P"><push><end_state state="A.C"/></push></transition></state>
<state name="C"><transition name="Q"><pop/></transition><transition name="Same"><simple/></transition></state>
<default_state><transition name="D"><internal/></transition></default_state>
</state>
<default_state><transition name="E"><internal/></transition></default_state>
</state_machine>"""
    )
    behavior = jsidl.load().services[0].behavior
    lines = path.read_text().splitlines()

    def at(text):
        return m.SourceLocation(str(path), next(number for number, line in enumerate(lines, 1) if text in line))

    assert behavior.stateless is False
    assert behavior.start == (m.Start("M", "A.B", at("<start ")),)
    (machine,) = behavior.machines
    assert machine.default_transitions == (m.Transition(trigger="E", kind="internal", where=at('name="E"')),)
    (state,) = machine.states
    assert (state.name, state.initial, state.where) == ("A", "B", at('<state name="A"'))
    assert state.entry == (m.ActionCall("hello"),)
    assert state.exit == (m.ActionCall("Send", ("'Bye'", "who")),)
    assert state.transitions == (
        m.Transition(
            trigger="t.Receive",
            kind="simple",
            parameters=(m.Parameter("Msg", "msg"),),
            guard="ok( msg ) && x",
            end_state="A.C",
            actions=(m.ActionCall("go"),),
            where=at("t.Receive"),
        ),
        m.Transition(trigger="", kind="internal", where=at("<default_transition>")),
    )
    assert state.default_transitions == (m.Transition(trigger="D", kind="internal", where=at('name="D"')),)
    b, c = state.states
    assert b.transitions == (m.Transition(trigger="P", kind="push", end_state="A.C", where=at('name="P"')),)
    assert [(t.kind, t.end_state) for t in c.transitions] == [("pop", None), ("simple", None)]


def parent(version):
    return f'<references><inherits_from name="p" id="urn:test:Parent" version="{version}"/></references>'


def test_newest_matching_parent(jsidl):
    for version in ("1.9", "1.10", "2.0"):
        jsidl.service(name="Parent", urn="urn:test:Parent", version=version)
    jsidl.service(references=parent("1.*"))
    schema = jsidl.load()
    assert schema.service("urn:test:Test").inherits_from == m.Reference("p", "urn:test:Parent", "1.10")
    assert [service.version for service in schema.services[:3]] == ["1.9", "1.10", "2.0"]
    assert schema.service("urn:test:Parent").version == "2.0"


def test_states_of_a_parent_are_accepted(jsidl):
    jsidl.service(
        name="Parent",
        urn="urn:test:Parent",
        behavior='<state_machine name="M"><state name="A"><state name="B"/></state></state_machine>',
    )
    jsidl.service(
        references=parent("1.0"),
        behavior='<start state_machine_name="p.M" state_name="A.B"/><state_machine name="p.M">'
        '<state name="A" initial_state="B"><transition name="T"><simple><end_state state="A.B"/></simple></transition>'
        "</state></state_machine>",
    )
    assert len(jsidl.load().services) == 2


def test_identical_definitions_are_merged(jsidl):
    path = jsidl.service()
    copy = jsidl.file("copy.xml", path.read_text().replace("<description>d<", "<description>\n other words <"))
    assert len(load_files([path, copy]).services) == 1


def test_parent_is_found_in_the_base(jsidl):
    jsidl.service(name="Parent", urn="urn:test:Parent")
    jsidl.service(name="Other", urn="urn:test:Other")
    base = jsidl.load()
    jsidl.paths.clear()
    jsidl.service(references=parent("1.*"))
    jsidl.service(name="Other", urn="urn:test:Other", messages="")
    schema = load_files(jsidl.paths, base=base)
    assert [service.key for service in schema.services] == [
        (f"urn:test:{n}", "1.0") for n in ("Other", "Parent", "Test")
    ]
    assert schema.service("urn:test:Test").inherits_from.key == ("urn:test:Parent", "1.0")
    assert schema.service("urn:test:Parent") is base.service("urn:test:Parent")
    assert (len(base.service("urn:test:Other").messages), len(schema.service("urn:test:Other").messages)) == (1, 0)


def test_blanks_around_an_id_are_ignored(jsidl):
    jsidl.service(urn="\n urn:test:Test ")
    assert jsidl.load().services[0].id == "urn:test:Test"


def test_type_set_that_only_another_set_refers_to(jsidl):
    """Public files use names of sets that the sets they refer to have declared."""
    refer = '<declared_type_set_ref name="{0}" id="urn:{0}" version="1.0"/>'
    for name, refs in (("a", refer.format("b")), ("b", refer.format("a") + refer.format("c")), ("c", "")):
        jsidl.file(
            f"{name}.xml",
            f'<declared_type_set xmlns="urn:jaus:jsidl:1.0" name="{name}" id="urn:{name}" version="1.0">{refs}'
            f'<record name="R{name}"><fixed_field name="N" field_type="byte" field_units="one"/></record>'
            "</declared_type_set>",
        )
    body = jsidl.body('<declared_record name="R" declared_type_ref="c.Rc"/>', types=refer.format("a"))
    assert body.declared == m.DeclaredType("urn:c", "1.0", "Rc")


def test_order_of_files_does_not_matter(jsidl):
    jsidl.service(references=parent("1.0"))
    jsidl.service(name="Parent", urn="urn:test:Parent")
    assert load_files(jsidl.paths) == load_files(reversed(jsidl.paths))


def test_messages_with_one_id_and_the_same_content(jsidl):
    """Public definitions have them; what arrives is the same, whichever it is taken for."""
    record = '<record name="R"><fixed_field name="N" field_type="byte" field_units="one"/></record>'
    jsidl.service(messages=jsidl.message(record, name="First") + "\n" + jsidl.message(record, name="Second"))
    first, second = jsidl.load().services[0].inputs
    assert (first.name, second.name) == ("First", "Second")
    assert (first.code, first.body) == (second.code, second.body)
