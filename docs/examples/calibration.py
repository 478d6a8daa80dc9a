"""From the measured track of a car to the cam that this car needs."""

from cadgen import Design

calibration = Design.load("carbon_free_car").calibrate(["track.csv"], profile="actual")
for effect in calibration.effects:
    finding = effect.claim.finding
    print(finding.effect, {number.name: number.value for number in finding.values})
cam = calibration.as_built.cam(profile="actual")
print("ready to be written" if cam.passed else cam.failed)
