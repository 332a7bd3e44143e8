"""Robots as TOML files, and what is said about mistakes in them."""

from pathlib import Path

import pytest
from pydantic import TypeAdapter

from jauspy.errors import ConfigError
from jauspy.robot.config import RobotConfig
from jauspy.robot.robot_files import known, load, robot_model
from jauspy.robot.runner import RobotRunner
from jauspy.transport import LoopbackTransport

GOOD = """
name = "mine"
urdf = "mine.urdf"
subsystem = 7
node = 2

[tracks]
left = ["left"]
right = ["right"]

[[modules]]
type = "CM-MOB"
component = 33
"""


@pytest.fixture
def write(tmp_path):
    def write(text: str):
        path = tmp_path / "robot.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return write


def test_inc1_is_included():
    config = load("inc1")
    assert "inc1" in known()
    assert [str(config.id_of(module)) for module in config.modules] == [
        "101.1.102",
        "101.1.103",
        "101.1.104",
        "101.1.105",
        "101.1.108",
        "101.1.110",
        "101.1.113",
        "101.1.106",
        "101.1.107",
        "101.1.109",
    ]
    assert (config.backend, config.world) == ("sim", "yard")


def lax_values(schema: object, names: tuple[str, ...] = ()):
    """The keys of a schema of pydantic whose numbers or flags are converted from something else."""
    if isinstance(schema, dict):
        if str(schema.get("ref", "")).startswith(("jauspy.services.", "jauspy.messages.")):
            return  # objects of Python, made from tables that are declared elsewhere
        if schema.get("type") in ("int", "float", "bool") and not schema.get("strict"):
            yield ".".join(names)
        names = (*names, schema["name"]) if isinstance(schema.get("name"), str) else names
        for key, part in schema.items():
            yield from lax_values(part, (*names, key) if schema.get("type") == "model-fields" else names)
    elif isinstance(schema, list | tuple):
        for part in schema:
            yield from lax_values(part, names)


def test_no_table_takes_true_or_text_for_a_number():
    assert list(lax_values(RobotConfig.__pydantic_core_schema__)) == []
    assert list(lax_values(TypeAdapter(tuple[int, ...]).core_schema)) == [""]


@pytest.mark.parametrize("name", known())
def test_all_included_robots_are_valid(name):
    assert load(name).name == name


@pytest.mark.parametrize(
    ("camera", "problem"),
    [
        ('name = "a"', "cameras.*needs the link that carries it, or else `outside`"),
        ('name = "a"\nlink = "base_link"\noutside = "chase"', "not both"),
        ('name = "a"\noutside = "above"', "outside"),
        ('name = "a"\noutside = "orbit"\ndepth = {}', "measures no depths"),
        ('name = "a"\nlink = "base_link"\nimaging = { aperture = [8.0, 2.8] }', "aperture"),
        ('name = "a"\nlink = "base_link"\nimaging = { iso = 100 }', "iso"),
    ],
)
def test_errors_of_cameras_name_the_key(write, camera, problem):
    with pytest.raises(ConfigError, match=problem):
        load(write(f'extends = "inc1"\n[[cameras]]\n{camera}\n'))


def test_user_file_is_loaded_by_path_and_text(write):
    path = write(GOOD)
    config = load(path)
    assert load(str(path)) == config
    assert str(config.id_of(config.modules[0])) == "7.2.33"
    assert (config.backend, config.world) == ("kinematic", "empty")
    assert config.modules[0].access_control.timeout == 5


def test_unknown_robot_lists_the_known_ones():
    with pytest.raises(ConfigError, match=r"'inc9'.*inc1.*\.toml"):
        load("inc9")


def test_missing_file_is_named(tmp_path):
    with pytest.raises(ConfigError, match=r"nowhere\.toml: cannot be read: No such file"):
        load(tmp_path / "nowhere.toml")


@pytest.mark.parametrize("text", ["name = ", "name = 'a'\nname = 'b'", "[[modules]"])
def test_invalid_toml_is_an_error(write, text):
    with pytest.raises(ConfigError, match=r"robot\.toml: is not TOML: .*(line|document)"):
        load(write(text))


def test_binary_file_is_an_error(write, tmp_path):
    path = tmp_path / "robot.toml"
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(ConfigError, match="is not TOML"):
        load(path)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("subsystem = 7", "subsystem = 65535", r"subsystem = 65535: .*65534"),
        ("subsystem = 7", "", r"subsystem: is missing"),
        ("subsystem = 7", "subsytem = 7", r"subsytem = 7: there is no such key; known here are: .*subsystem"),
        ("node = 2", "node = 'two'", r"node = 'two': .*integer"),
        ("component = 33", "component = 255", r"modules\[0\]\.component = 255: .*254"),
        ("CM-MOB", "CM-BOM", r"modules\[0\]\.type = 'CM-BOM': .*'CM-MOB'"),
        ("component = 33", "component = 33\nspeed = 3", r"modules\[0\]\.speed = 3: .*known here are: access_control"),
        (
            "component = 33",
            "component = 33\ncomms_lost = { far = 1 }",
            r"comms_lost\.far = 1: .*known here are: distance, policy, regained, regained_timeout, speed, timeout",
        ),
        (
            "component = 33",
            "component = 33\ncomms_lost = { timeout = 2 }",
            r"comms_lost\.timeout = 2: too short: an idle client .* 4 s; give 4 or more, or 0 for",
        ),
        (
            "component = 33",
            "component = 33\ncomms_lost = { timeout = true }",
            r"comms_lost\.timeout = True: input should be a valid integer",
        ),
        (
            "node = 2",
            "node = 2\nbattery = { capacity = true, full_voltage = 30, empty_voltage = 20 }",
            r"battery\.capacity = True: input should be a valid number",
        ),
        ("node = 2", "node = 2\nskip_missing_packages = 1", r"skip_missing_packages = 1: .*valid boolean"),
        ("node = 2", "node = 2\nmax_message_age = '5'", r"max_message_age = '5': input should be a valid number"),
        (
            "component = 33",
            "component = 33\nservices = ['Tim']",
            r"services: a CM-MOB has no service 'Tim'; it can have: .*Time, Liveness.*LocalPoseSensor",
        ),
        (
            "component = 33",
            "component = 33\naccess_control = { timeout = 256 }",
            r"modules\[0\]\.access_control\.timeout = 256: .*255",
        ),
        (
            "component = 33",
            "component = 33\naccess_control = { timout = 2 }",
            r"access_control\.timout = 2: .*known here are: default_authority, timeout",
        ),
        (
            "component = 33",
            "component = 33\n[[modules]]\ntype = 'CM-MOB'\ncomponent = 33",
            r"modules: 2 have the component id 33",
        ),
        (
            "component = 33",
            "component = 33\n[[modules]]\ntype = 'CM-MOB'\ncomponent = 34",
            r"modules: 33 and 34 both move the chassis",
        ),
        ("component = 33", "component = 33\ngroup = 'arm'", r"group: a CM-MOB moves no group of joints"),
        (
            "component = 33",
            "component = 33\n[[modules]]\ntype = 'CM-MAN'\ncomponent = 34",
            r"modules: 34 moves the group 'arm', which is not there; there are: none",
        ),
        ("[[modules]]", "[[lidars]]\nname = 'l'\nlink = 'm'\nrays = 0\n[[modules]]", r"lidars\[0\]\.rays = 0: .*1"),
        (
            "[[modules]]",
            "[[lidars]]\nname = 'l'\nlink = 'm'\nrange = [3, 2]\n[[modules]]",
            r"range: \[3.0, 2.0\] is empty",
        ),
        (
            "[[modules]]",
            "[[lidars]]\nname = 'l'\nlink = 'm'\n[[lidars]]\nname = 'l'\nlink = 'n'\n[[modules]]",
            r"lidars: l is there twice",
        ),
        (
            "component = 33",
            "component = 33\n[[modules]]\ntype = 'CM-SEN'\ncomponent = 34\nservices = ['RangeSensor']",
            r"lidars: there is none, and 34 offers RangeSensor; add \[\[lidars\]\]",
        ),
        (
            "component = 33",
            "component = 33\n[[modules]]\ntype = 'CM-SEN'\ncomponent = 34\nservices = ['ForceTorqueSensor']",
            r"force_torque: there is none, and 34 offers ForceTorqueSensor; add \[\[force_torque\]\]",
        ),
        (
            "[[modules]]",
            "[[force_torque]]\nname = 'l'\nlink = 'm'\nforce = 0\n[[modules]]",
            r"force_torque\[0\]\.force = 0: .*0",
        ),
        (
            "[[modules]]",
            "[[cameras]]\nname = 'c'\nlink = 'l'\ndepth = { range = [3, 2] }\n[[modules]]",
            r"range: \[3.0, 2.0\] is empty",
        ),
        (
            "[[modules]]",
            "[[cameras]]\nname = 'c'\nlink = 'l'\ndepth = { size = [1920, 1080] }\n[[modules]]",
            r"size: \[1920, 1080\] are too many points for one message; it has 1000000",
        ),
        (
            "component = 33",
            "component = 33\nservices = []",
            r"none has the service Discovery; without it the robot cannot be discovered",
        ),
        ("component = 33", "component = 33\nservices = ['PrimitiveDriver']", r"none has the service Discovery"),
        (
            "component = 33",
            "component = 33\nservices = ['Discovery', 'GlobalPoseSensor']",
            r"origin: is missing; GlobalPoseSensor cannot",
        ),
        ("[[modules]]", "[origin]\nlatitude = 91.0\nlongitude = 0.0\n[[modules]]", r"origin\.latitude = 91\.0: .*90"),
        ("[[modules]]", "[origin]\nlatitude = 9.0\n[[modules]]", r"origin\.longitude: is missing"),
        ('"mine"', '"Ωmega"', r"name: 'Ωmega': JAUS sends names in Latin-1, which has no 'Ω'"),
    ],
)
def test_mistakes_name_the_key_and_the_permitted_values(write, old, new, said):
    with pytest.raises(ConfigError, match=said):
        load(write(GOOD.replace(old, new)))


def test_latin_1_names_are_accepted(write):
    assert load(write(GOOD.replace('"mine"', '"Jürgen"'))).name == "Jürgen"


def test_offered_services_are_listed(write):
    (module,) = load(write(GOOD)).modules
    assert module.offers("PrimitiveDriver")
    (module,) = load(write(GOOD + "services = ['Discovery', 'LocalPoseSensor']")).modules
    assert module.offers("LocalPoseSensor")
    assert not module.offers("PrimitiveDriver")


def test_an_origin_is_read(write):
    origin = load(write(GOOD + "[origin]\nlatitude = 38.5\nlongitude = -77.0\nheading = 45.0\n")).origin
    assert (origin.latitude, origin.longitude, origin.altitude, origin.heading) == (38.5, -77.0, 0.0, 45.0)


def test_a_robot_without_modules(write):
    with pytest.raises(ConfigError, match=r"modules: there is none"):
        load(write("modules = []\n" + GOOD.partition("[[modules]]")[0]))


def test_all_mistakes_are_reported_at_once(write):
    with pytest.raises(ConfigError) as caught:
        load(write("name = ''"))
    assert str(caught.value).count("\n") >= 4


def test_extends_inherits_keys(write):
    config = load(write('extends = "inc1"\nname = "seven"\nsubsystem = 7'))
    parent = load("inc1")
    assert (config.name, config.subsystem, config.urdf) == ("seven", 7, parent.urdf)
    assert config.groups == parent.groups


def test_cyclic_extends_is_an_error(write):
    with pytest.raises(ConfigError, match=r"robot\.toml: extends = '\./robot\.toml': .*not lead back"):
        load(write('extends = "./robot.toml"'))


def test_what_does_not_match_the_urdf_is_reported_with_file_and_line(tmp_path):
    examples = Path(__file__).parents[2] / "examples"
    (tmp_path / "tracked.urdf").write_bytes((examples / "tracked.urdf").read_bytes())
    file = tmp_path / "mine.toml"
    text = (examples / "tracked.toml").read_text()

    file.write_text(text.replace('["left"]', '["leftt"]'))
    with pytest.raises(ConfigError) as caught:
        robot_model(load(file))
    assert str(caught.value).startswith(f"{file}: line 14: tracks.left: 'leftt' is not a prismatic joint of the URDF")

    file.write_text(text.replace("tracked.urdf", "none.urdf"))
    with pytest.raises(ConfigError) as caught:
        robot_model(load(file))
    assert str(caught.value) == f"{file}: line 3: urdf: {tmp_path / 'none.urdf'}: there is no such file"


async def test_a_backend_that_is_not_installed_is_reported_with_file_and_line_or_as_it_was_given(tmp_path):
    examples = Path(__file__).parents[2] / "examples"
    config = load(examples / "tracked.toml")
    with pytest.raises(ConfigError, match=r"tracked\.toml: line 4: backend: no backend 'tracked'; installed are: "):
        await RobotRunner(config, LoopbackTransport).open()
    with pytest.raises(ConfigError, match=r"^backend: no backend 'other'; installed are: "):
        await RobotRunner(config, LoopbackTransport, backend="other").open()


@pytest.mark.parametrize("value", ['"never"', "0", "true", '{ PrimitiveDriver = "never" }'])
def test_a_wrong_time_limit_of_commands_is_one_sentence(write, value):
    with pytest.raises(ConfigError) as caught:
        load(write(f"{GOOD}command_timeout = {value}\n"))
    (problem,) = str(caught.value).splitlines()[1:]
    assert 'is neither seconds (above 0, up to 3600) nor "off"' in problem
    assert problem.startswith("  line 14: modules[0].command_timeout = ")
