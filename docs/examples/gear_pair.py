"""A pair of gears in mesh with 0.1 mm of backlash, as a build123d assembly."""

from build123d import export_step

from cadgen import Gear, GearPair

pinion = Gear(teeth=18, module=1.0, width=8.0, bore=5.0)
wheel = Gear(teeth=45, module=1.0, width=6.0, bore=8.0)
pair = GearPair(pinion, wheel, backlash=0.1)
print(f"axes {pair.axes_apart:g} mm apart, contact ratio {pair.contact_ratio:.2f}")
assembly = pair.build123d()
export_step(assembly, "pair.step")
