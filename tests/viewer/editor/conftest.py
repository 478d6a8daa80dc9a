"""A small design with comments, and its page served in this process."""

import pytest

from cadgen.design.load import packaged_designs
from cadgen.progress import silent
from cadgen.viewer.editor.compute import compute
from cadgen.viewer.editor.guard import Address
from cadgen.viewer.editor.server import Service, application
from cadgen.viewer.editor.session import Session

CARS = [name for name, file in packaged_designs().items() if "[path]" in file.read_text(encoding="utf-8")]

TEXT = """\
# A small car.   Its comments are to stay.
name = "small"

[path]
waypoints_mm = [   # from the left
    [0.0, 0.0], [1500.0, 200.0],
    [2600.0, 1200.0],  # the turn
    [4000.0, 1500.0], [5500.0, 1000.0],
]

[[course.posts]]   # in the way
at_mm = [2600.0, 300.0]
radius_mm = 20.0

[car]
wheelbase_mm = 167.0   # L
drive_wheel_offset_mm = 37
idle_wheel_offset_mm = 201

[car.outline]
length_mm = 220
width_mm = 240
front_overhang_mm = 30

[cam]
base_radius_mm = 70
mid_plane_mm = 25
thickness_mm = 3   # C

[follower]
radius_mm = 2.5
"""


class Here:
    """A worker without a process."""

    def run(self, job):
        return compute(job, silent)

    def supersede(self, revision):
        pass


@pytest.fixture
def file(tmp_path):
    place = tmp_path / "small.toml"
    place.write_bytes(TEXT.encode())
    return place


@pytest.fixture
def session(file):
    return Session(file)


@pytest.fixture
def address():
    return Address(8123, "abc-token")


@pytest.fixture
def service(session):
    return Service(session, {"preview": Here(), "whole": Here()})


@pytest.fixture
def client(service, address):
    """The page's own requests."""
    testclient = pytest.importorskip("starlette.testclient")
    own = f"http://{address.host}"
    made = testclient.TestClient(application(service, address), base_url=f"{own}/{address.token}/")
    made.headers.update({"origin": own})
    return made
