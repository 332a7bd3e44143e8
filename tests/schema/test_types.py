"""Every kind of field and composite, read from a few lines of XML."""

from __future__ import annotations

import math

import pytest

from jauspy.schema import model as m

U8 = 'field_type_unsigned="unsigned byte"'


@pytest.mark.parametrize(
    ("xml", "short"),
    [
        ("unsigned byte", "u8"),
        ("unsigned short integer", "u16"),
        ("unsigned integer", "u32"),
        ("unsigned long integer", "u64"),
        ("byte", "i8"),
        ("short integer", "i16"),
        ("integer", "i32"),
        ("long integer", "i64"),
        ("float", "f32"),
        ("long float", "f64"),
        ("unsigned\n   byte", "u8"),
    ],
)
def test_number_types(jsidl, xml, short):
    field = jsidl.field(f'<fixed_field name="N" field_type="{xml}" field_units="meter" optional="false"/>')
    assert field == m.FixedField(name="N", type=short, units="meter")


@pytest.mark.parametrize("function", ["round", "floor", "ceiling"])
def test_scale_with_constants(jsidl, function):
    jsidl.file(
        "consts.xml",
        '<declared_const_set xmlns="urn:jaus:jsidl:1.1" name="C" id="urn:c" version="1.0">'
        '<const_def name="HALF" const_type="float" field_units="one" const_value="TWO / 4"/>'
        '<const_def name="TWO" const_type="byte" field_units="one" const_value="2"/></declared_const_set>',
    )
    field = jsidl.field(
        '<fixed_field name="N" field_type="unsigned byte" field_units="radian" optional="true" interpretation=" a\n b">'
        ""
        f'<scale_range real_lower_limit="-2*PI" real_upper_limit="c.HALF" integer_function="{function}"/>'
        "</fixed_field>",
        consts='<declared_const_set name="k"><declared_const_set_ref name="c" id="urn:c" version="1.0"/><const_def '
        'name="PI" const_type="float" field_units="one" const_value="3.141592653589793"/></declared_const_set>',
    )
    scale = m.Scale(-2 * math.pi, 0.5, function)
    assert field == m.FixedField(name="N", optional=True, doc="a b", type="u8", units="radian", scale=scale)


def test_values(jsidl):
    field = jsidl.field(
        '<fixed_field name="N" field_type="byte" field_units="one" optional="false">'
        '<value_set offset_to_lower_limit="true"><value_enum enum_index="1" enum_const="ON"/>'
        '<value_range lower_limit="0" lower_limit_type="exclusive" upper_limit="7" upper_limit_type="inclusive"/>'
        "</value_set></fixed_field>"
    )
    assert field.values == m.ValueSet((m.ValueEnum(1, "ON"),), (m.ValueRange(0, 7, False, True),), True)


def test_declared_values(jsidl):
    field = jsidl.field(
        '<fixed_field name="N" field_type="byte" field_units="one" optional="false">'
        '<declared_value_set name="V" declared_type_ref="OnOff"/></fixed_field>',
        types='<value_set name="OnOff"><value_enum enum_index="1" enum_const="ON"/></value_set>',
    )
    assert field.values == m.ValueSet((m.ValueEnum(1, "ON"),))


def test_bit_field(jsidl):
    field = jsidl.field(
        f'<bit_field name="B" {U8} optional="false">'
        '<sub_field name="Low" interpretation="low"><bit_range from_index="0" to_index="2"/></sub_field>'
        '<sub_field name="High"><bit_range from_index="7" to_index="7"/><value_set offset_to_lower_limit="false">'
        '<value_enum enum_index="0" enum_const="NO"/></value_set></sub_field></bit_field>'
    )
    high = m.SubField("High", 7, 7, m.ValueSet((m.ValueEnum(0, "NO"),)))
    assert field == m.BitField(name="B", type="u8", subfields=(m.SubField("Low", 0, 2, doc="low"), high))


def test_variable_field(jsidl):
    field = jsidl.field(
        '<variable_field name="V" optional="true"><type_and_units_field>'
        '<type_and_units_enum name="Metres" index="0" field_type="unsigned byte" field_units="meter" '
        'interpretation="m">'
        '<scale_range real_lower_limit="0" real_upper_limit="1" integer_function="round"/></type_and_units_enum>'
        '<type_and_units_enum index="7" field_type="float" field_units="second"/>'
        "</type_and_units_field></variable_field>"
    )
    metres = m.TypeChoice(0, "u8", "meter", m.Scale(0, 1), name="Metres", doc="m")
    assert field == m.VariableField(name="V", optional=True, choices=(metres, m.TypeChoice(7, "f32", "second")))


def test_strings_and_blobs(jsidl):
    record = jsidl.body(
        f"""<record name="Rec" optional="false"><presence_vector {U8}/>
        <fixed_length_string name="F" string_length="2 * 40" optional="true"/>
        <variable_length_string name="S" optional="false"><count_field {U8}/></variable_length_string>
        <variable_length_field name="L" field_format="JAUS MESSAGE" optional="false">
          <count_field field_type_unsigned="unsigned integer" min_count="2" max_count="2147483647"/>
        </variable_length_field>
        <variable_format_field name="W" optional="false">
          <format_field><format_enum index="0" field_format="JPEG"/>
            <format_enum index="9" field_format="x"/></format_field>
          <count_field field_type_unsigned="unsigned short integer" max_count="9"/>
        </variable_format_field></record>"""
    )
    assert record.presence == "u8"
    assert record.fields == (
        m.FixedString(name="F", optional=True, length=80),
        m.VariableString(name="S", count=m.Count("u8", 0, 255)),
        m.VariableLengthField(name="L", format="JAUS MESSAGE", count=m.Count("u32", 2, 2**31 - 1)),
        m.VariableFormatField(
            name="W", formats=(m.Format(0, "JPEG"), m.Format(9, "x")), count=m.Count("u16", 0, 9)
        ),
    )  # fmt: skip


def test_array(jsidl):
    field = jsidl.field(
        '<array name="A" optional="true"><declared_fixed_field name="E" declared_type_ref="Byte"/>'
        '<dimension name="row" size="3"/><dimension name="column" size="2+2"/></array>',
        types='<fixed_field name="Byte" field_type="unsigned byte" field_units="one" optional="false"/>',
    )
    element = m.FixedField(name="E", type="u8", declared=m.DeclaredType("urn:test:Test", "1.0", "Byte"))
    assert field == m.Array(
        name="A", optional=True, element=element, dimensions=(m.Dimension("row", 3), m.Dimension("column", 4))
    )


def number(name: str, optional: str = "false") -> str:
    field = '<fixed_field name="N" field_type="byte" field_units="one"/>'
    return f'<record name="{name}" optional="{optional}">{field}</record>'


def test_composites(jsidl):
    body = jsidl.body(
        f"""<sequence name="Seq" optional="false"><presence_vector {U8}/>
        <list name="Items" optional="true" interpretation="i"><count_field {U8} min_count="1"/>{number("Item")}</list>
        <variant name="Var" optional="false"><vtag_field {U8} max_count="1"/>{number("A")}{number("B")}</variant>
        </sequence>"""
    )

    def record(name):
        return m.Record(name=name, fields=(m.FixedField(name="N", type="i8"),))

    items = m.List(name="Items", optional=True, doc="i", count=m.Count("u8", 1, 255), element=record("Item"))
    variant = m.Variant(name="Var", tag=m.Count("u8", 0, 1), arms=(record("A"), record("B")))
    assert body == m.Sequence(name="Seq", items=(items, variant), presence="u8")


def test_variant_without_arms_has_empty_arms(jsidl):
    body = jsidl.body(f'<variant name="Var" optional="false"><vtag_field {U8} max_count="1"/></variant>')
    assert body.arms == (m.Record(name="Empty0", fields=()), m.Record(name="Empty1", fields=()))


def test_presence_vector_that_is_too_small_loads(jsidl):
    field = '<fixed_field name="N{}" field_type="byte" field_units="one" optional="true"/>'
    fields = "".join(field.format(i) for i in range(9))
    assert len(jsidl.body(f'<record name="R" optional="false"><presence_vector {U8}/>{fields}</record>').fields) == 9


def test_declared_types_across_files(jsidl):
    jsidl.file(
        "inner.xml",
        '<declared_type_set xmlns="urn:jaus:jsidl:1.0" name="Inner" id="urn:inner" version="2.0">'
        '<record name="Rec" optional="false" interpretation="rec">'
        '<fixed_field name="N" field_type="byte" field_units="one"/></record></declared_type_set>',
    )
    jsidl.file(
        "outer.xml",
        '<declared_type_set xmlns="urn:jaus:jsidl:1.1" name="Outer" id="urn:outer" version="1.0">'
        '<declared_type_set_ref name="inner" id="urn:inner" version="2.0"/>'
        '<declared_record name="Alias" declared_type_ref="inner.Rec"/></declared_type_set>',
    )
    body = jsidl.body(
        f"""<sequence name="Seq" optional="false"><presence_vector {U8}/>
        <declared_record name="A" declared_type_ref="outer.Alias" optional="true"/>
        <declared_record name="B" declared_type_ref="outer.inner.Rec" optional="false" interpretation="b"/>
        <declared_record name="C" declared_type_ref="inner.Rec" optional="false"/></sequence>""",
        types='<declared_type_set_ref name="outer" id="urn:outer" version="1.0"/>',
    )
    made = {"fields": (m.FixedField(name="N", type="i8"),), "declared": m.DeclaredType("urn:inner", "2.0", "Rec")}
    assert body.items == (
        m.Record(name="A", optional=True, doc="rec", **made),
        m.Record(name="B", doc="b", **made),
        m.Record(name="C", doc="rec", **made),
    )
