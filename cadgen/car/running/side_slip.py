"""Side slip of a car with one driven wheel: the rolling resistance of the others turns it, and slip angles hold it.

The driven wheel pushes at one side. The front wheel stands A1 from it across, the idle wheel A1 + A2. Their rolling
resistance c N makes the yaw moment M = c N (2 A1 + A2), some 15 N mm on a car of 1.5 kg. Side forces M / L on the front
wheel and on the rear axle hold it. Let C be the cornering stiffness for a unit of load. Then a wheel takes its force at
the slip angle M / (L C N), and the two rear wheels together at half of that. The car then runs as if its front wheel
were turned by the sum of both, 1.5 c (2 A1 + A2) / (L C), whatever it weighs.

It is a constant, which a trim takes out, until the resistance changes from run to run. No measured stiffness of such
wheels is known: 10 to 50 for a rad and a unit of load is a wide guess, and 20 its middle.
"""

from cadgen.car.steering import Car

RESISTANCE = 0.01  # rolling resistance by load, of small wheels on bearings
STIFFNESS = 20.0  # 1/rad, for a unit of load; from 10 to 50
CHANGE = 0.2  # of the resistance from run to run


def side_slip(car: Car, stiffness: float = STIFFNESS) -> float:
    """Sum of the slip angles of front wheel and rear axle, as a turn of the front wheel, rad; equal loads.

    Args:
        car: dimensions of the car.
        stiffness: cornering stiffness for a unit of load, 1/rad.
    """
    arm = abs(2 * car.drive_wheel_offset + car.idle_wheel_offset)
    return 1.5 * RESISTANCE * arm / (car.wheelbase * stiffness)
