"""Film forces of lubricated revolute joints, and a check of other implementations of them.

    import lubjoint
    bearing = lubjoint.Bearing(viscosity=0.04, length=0.04, radius=0.01, clearance=2e-4)
    radial, tangential = lubjoint.polar_force("short_half", bearing, eccentricity_ratio, slip_rate, squeeze_rate)
    print(lubjoint.verify(my_function, law="pinkus_sternlicht"))

Units are SI. Arrays are read and written where they are, with their strides; nothing is copied that is of type float64.
"""

from ._film import (Bearing, Coefficients, Contact, Losses, film_coefficients, film_losses, joint_moments, journal_force,
                    laws, polar_force, transition_force, version)
from ._verify import Report, states, verify

__version__ = version()

__all__ = [
    "Bearing",
    "Coefficients",
    "Contact",
    "Losses",
    "Report",
    "film_coefficients",
    "film_losses",
    "joint_moments",
    "journal_force",
    "laws",
    "polar_force",
    "states",
    "transition_force",
    "verify",
]
