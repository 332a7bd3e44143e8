"""A CM-VIS in memory, and a camera that does what tests say."""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime, timedelta

from jauspy.backends.kinematic import KinematicRobot
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import environment_sensing as m, registry
from jauspy.messages.core import RequestControl, Resume
from jauspy.platform.video_settings import RTP_SERVER_TYPE, VideoSettings
from jauspy.protocol.addressing import Location
from jauspy.robot import robot_files
from jauspy.robot.config import AccessControlConfig
from jauspy.robot.hosts import host_of
from jauspy.robot.robot_files import robot_model

CLIENT, OTHER = JausID(42, 1, 1), JausID(42, 2, 1)
HERE = Location(is_here=True, hosts=frozenset({"10.0.0.7", "10.0.0.8"}))
START = datetime(2026, 1, 1, tzinfo=UTC)


class FakeVideo:
    """A camera that only remembers; its still images come when the test says so."""

    def __init__(self, setup):
        self.setup, self.settings, self.receivers = setup, VideoSettings(), {}
        self.imaging = setup.imaging.initial
        self.under_way, self.refuses = [], False
        self.reduced = ""

    def watch(self, address, *, playing=True):
        if address[1] == 666:
            raise ConfigError("no more receivers")
        self.receivers[address] = playing

    def leave(self, address):
        self.receivers.pop(address, None)

    def take(self, settings, then):
        if self.refuses:
            raise ConfigError("too many are under way")
        self.under_way.append((settings, then))

    def develop(self, still):
        """The pictures that are under way come now."""
        under_way, self.under_way = self.under_way, []
        for _, then in under_way:
            then(still)


class Module:
    """The CM-VIS of the chassis camera of a kinematic inc1; a `fixed` one is where the lidar is, without a mount."""

    def __init__(self, component=107, video=None, *, fixed=False, older_versions=False):
        config = robot_files.load("inc1")
        if fixed:
            config = _with_fixed_cameras(config)
        model = robot_model(config)
        self.robot = KinematicRobot(model)
        self.now = 0.0
        self.where = {}
        """Machines of clients, unless they are on this one."""
        (module,) = (each for each in config.modules if each.component == component)
        update = {"access_control": AccessControlConfig(timeout=0), "older_versions": older_versions}
        module = module.model_copy(update=update)
        (setup,) = (each for each in model.cameras if each.name == module.camera)
        self.video = video(self.robot.cameras[module.camera]) if video else FakeVideo(setup)
        clock = lambda: START + timedelta(seconds=self.now)  # noqa: E731
        videos = {module.camera: self.video}
        self.host = host_of(config, module, model, self.robot, {}, videos=videos, utc_now=clock, now=0.0)
        self.host.locate = lambda client, found: found(self.where.get(client, HERE))

    def tell(self, *messages, client=CLIENT):
        for message in messages:
            self.host.receive(message.encode(), client, self.now)
        return [registry.decode(each.payload) for each in self.host.poll_output(self.now)]

    def ask(self, query, client=CLIENT):
        (answer,) = self.tell(query, client=client)
        return answer

    def run(self, seconds=0.0):
        """Let time pass; what is sent meanwhile."""
        end, sent = self.now + seconds, []
        while (due := self.host.next_timeout()) is not None and due <= end:
            self.now = max(self.now, due)
            self.host.handle_timeout(self.now)
            sent += [(each.destination, registry.decode(each.payload)) for each in self.host.poll_output(self.now)]
        self.now = end
        return sent

    def enter(self, url, client=CLIENT, server=RTP_SERVER_TYPE, sensor=1):
        register = m.RegisterDigitalResourceEndpoint
        record = register.DigitalResourceEndpointRec(server, url, None, sensor)
        now = self.tell(register(register.RequestIDRec(9), record), client=client)
        (answer,) = now or [message for _, message in self.run()]
        assert answer.request_id == 9
        return answer.id

    def control(self, client=CLIENT):
        self.tell(RequestControl(200), Resume(), client=client)


def _with_fixed_cameras(config):
    cameras = tuple(replace(camera, link="lidar_link", outside=None) for camera in config.cameras)
    modules = tuple(
        each.model_copy(update={"group": None}) if each.type == "CM-VIS" else each for each in config.modules
    )
    return config.model_copy(update={"cameras": cameras, "modules": modules})
