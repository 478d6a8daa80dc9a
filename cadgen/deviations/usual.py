"""How much cars differ in what nobody has measured on them yet.

Standard deviations of the numbers of effects, by the names of the numbers and in their units, of parts made with care
in a workshop and put together by hand. A design's own [tolerances] come before them.
"""

from cadgen.deviations.effect import Parameter

USUAL = {
    "steering_zero_deg": 0.05,
    "gain_percent": 0.3,
    "wheel_radius_percent": 0.2,
    "drive_wheel_offset_mm": 0.3,
    "slip_percent": 1.0,
    "phase_deg": 0.2,
    "return_error_deg": 0.2,
    "friction": 0.06,
    "eccentric_x_um": 10.0,
    "eccentric_y_um": 10.0,
    "cutter_offset_um": 10.0,
    "scale_percent": 0.02,
    "scale_x_percent": 0.02,
    "scale_y_percent": 0.02,
    "reversal_x_um": 3.0,
    "reversal_y_um": 3.0,
    "square_deg": 0.01,
    "shaft_x_um": 5.0,
    "shaft_y_um": 5.0,
    "rod_radius_um": 5.0,
    "axial_offset_um": 50.0,
    "wobble_cos_um": 30.0,
    "wobble_sin_um": 30.0,
    "lost_motion_um": 3.0,
    "hysteresis_um": 2.0,
    "drift_um_per_run": 3.0,
    "indicator_tilt_deg": 0.5,
    "rate_percent": 0.01,
    "wind_up_deg": 0.03,
    "runout_cos_deg": 0.03,
    "runout_sin_deg": 0.03,
    "mesh_cos_deg": 0.01,
    "mesh_sin_deg": 0.01,
    "stylus_um": 5.0,
    "machine_percent": 0.005,
    "machine_x_percent": 0.005,
    "machine_y_percent": 0.005,
    "machine_square_deg": 0.003,
    "divider_deg": 0.2,
    "index_cos_deg": 0.02,
    "index_sin_deg": 0.02,
    "reading_lag_deg": 0.02,
}
# The same of a tricycle whose steering and travel are logged.
LOGGED = {
    "steering_zero_deg": 2.0,
    "gain_percent": 1.0,
    "wheelbase_percent": 3.0,
    "wheel_radius_percent": 1.0,
    "lag_s": 0.05,
    "marker_ahead_mm": 3.0,
    "marker_left_mm": 3.0,
    "slip_percent": 1.0,
}
_STEPS = 5.0  # of a number that is not in the table, as of an effect that a program has added


def usual(parameter: Parameter, *, logged: bool = False) -> float:
    """Standard deviation from car to car, or of a car whose steering is `logged`, internal units."""
    return (LOGGED if logged else USUAL).get(parameter.name, _STEPS * parameter.step) * parameter.scale
