"""A cam: changed, checked, drawn, and written as files that the follower was rolled on."""

from cadgen import Design

design = Design.load("carbon_free_car").with_({"cam.thickness_mm": 3.2})
cam = design.cam(profile="actual")
cam.plot().savefig("cam.png")
files = cam.write("exports", formats=["step", "dxf"])
for file in files:
    print(f"{file.name}: {file.lift_error_um:.3f} µm at the follower's lift")
