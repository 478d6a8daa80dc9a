"""A cam by its motion: 14 mm up, a dwell, back, under a roller; its forces, its files."""

from math import radians as rad

from cadgen import Cam, Motion, Roller, Spring, dwell, rise

motion = Motion([rise(14, rad(80)), dwell(rad(50)), rise(-14, rad(110), "modified_sine"), dwell(rad(120))])
cam = Cam(motion, Roller(radius=9, offset=8), base_circle_radius=32, thickness=10, bore=12, name="feeder")
forces = cam.forces(rpm=420, mass=0.85, spring=Spring(rate=9, preload=60))
print(f"the roller leaves the disc at {forces.lift_off_rpm:.0f} rev/min")  # the roller leaves the disc at 676 rev/min
cam.write("exports", formats=["step", "dxf"])
