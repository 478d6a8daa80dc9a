"""Least and greatest of what may be asked of a plan."""

WITHIN_MM = 0.1, 1000.0  # how far a given path may be left, mm
SEEDS = 1, 100  # searches
RESERVE = 0.0, 10.0  # room at gates and obstacles, times the scatter of the cars
