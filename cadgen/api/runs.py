"""Runs of cars: what a simulation, random cars and a budget of errors give."""

from cadgen.jobs.cam.remedies import Remedy as Remedy
from cadgen.jobs.error_budget import BudgetSheet as BudgetSheet
from cadgen.jobs.error_budget import shown_half_width as shown_half_width
from cadgen.jobs.error_budget import shown_value as shown_value
from cadgen.jobs.simulation import Simulation as Simulation
from cadgen.jobs.tolerance import Spread as Spread
from cadgen.jobs.tolerance import ToleranceRun as ToleranceRun
