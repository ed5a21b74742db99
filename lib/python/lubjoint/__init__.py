"""Film forces of lubricated revolute joints, runs of mechanisms with them, and a check of other implementations.

    import lubjoint
    bearing = lubjoint.Bearing(viscosity=0.04, length=0.04, radius=0.01, clearance=2e-4)
    radial, tangential = lubjoint.polar_force("short_half", bearing, eccentricity_ratio, slip_rate, squeeze_rate)
    print(lubjoint.verify(my_function, law="pinkus_sternlicht"))
    run = lubjoint.simulate("slider-crank.toml", law="long_dynamic")
    run.t, run["crank.phi"], run.summary["energy_residual"]

Units are SI. Arguments broadcast against each other. Numbers and one-dimensional arrays of type float64 are read and
written where they are, with their strides; of arrays with more dimensions, those with gaps are copied.
"""

from ._film import (ForceJacobian, force_jacobian, joint_moments, journal_force, laws, polar_force, transition_force,
                    version)
from ._library import Bearing, Contact
from ._oracle import FilmTable, SolvedForce, film_table, oracle_force
from ._rest import (Coefficients, Equilibrium, Losses, Mobility, coefficients, equilibrium, film_coefficients,
                    film_losses, losses, mobility)
from ._simulate import Run, simulate
from ._verify import Report, states, verify

__version__ = version()

__all__ = [
    "Bearing",
    "Coefficients",
    "Contact",
    "Equilibrium",
    "FilmTable",
    "ForceJacobian",
    "Losses",
    "Mobility",
    "Report",
    "Run",
    "SolvedForce",
    "coefficients",
    "equilibrium",
    "film_coefficients",
    "film_losses",
    "film_table",
    "force_jacobian",
    "joint_moments",
    "journal_force",
    "laws",
    "losses",
    "mobility",
    "oracle_force",
    "polar_force",
    "simulate",
    "states",
    "transition_force",
    "verify",
]
