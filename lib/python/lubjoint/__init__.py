"""Film forces of lubricated revolute joints, and a check of other implementations of them.

    import lubjoint
    bearing = lubjoint.Bearing(viscosity=0.04, length=0.04, radius=0.01, clearance=2e-4)
    radial, tangential = lubjoint.polar_force("short_half", bearing, eccentricity_ratio, slip_rate, squeeze_rate)
    print(lubjoint.verify(my_function, law="pinkus_sternlicht"))

Units are SI. Arguments broadcast against each other. Numbers and one-dimensional arrays of type float64 are read and
written where they are, with their strides; of arrays with more dimensions, those with gaps are copied.
"""

from ._film import (Bearing, Coefficients, Contact, Equilibrium, Losses, Mobility, coefficients, equilibrium,
                    film_coefficients, film_losses, joint_moments, journal_force, laws, losses, mobility, polar_force,
                    transition_force, version)
from ._verify import Report, states, verify

__version__ = version()

__all__ = [
    "Bearing",
    "Coefficients",
    "Contact",
    "Equilibrium",
    "Losses",
    "Mobility",
    "Report",
    "coefficients",
    "equilibrium",
    "film_coefficients",
    "film_losses",
    "joint_moments",
    "journal_force",
    "laws",
    "losses",
    "mobility",
    "polar_force",
    "states",
    "transition_force",
    "verify",
]
