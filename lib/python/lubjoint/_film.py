"""Forces on journals over NumPy arrays, through the C interface."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import Optional, Sequence

import numpy
from numpy.typing import ArrayLike, NDArray

from ._library import (Array, Batch, Bearing, Contact, JacobianStruct, MotionStruct, Number, address_of, buffer_of, call,
                       check, float64, library, no_buffer)
from ._oracle import warn_beyond
from ._rest import coefficients, equilibrium  # noqa: F401  in an example


def version() -> str:
    """Version of the library."""
    return library.lubjoint_version().decode()


def laws() -> list[str]:
    """Names of the film laws: a list of texts.

    >>> "short_dynamic" in laws()
    True
    """
    names = []
    while (name := library.lubjoint_law_name(len(names))) is not None:
        names.append(name.decode())
    return names


_formulas = {name: name.encode() for name in laws() if not name.startswith("finite_")}
_polar_force, _journal_force = library.lubjoint_polar_force_gapless, library.lubjoint_journal_force_gapless
_empty = numpy.empty
_not_gapless = no_buffer + (KeyError,)


def _gapless(function, law, bearing, arrays, out):
    """The two answers for arrays of one length without gaps, for which the structures of a Batch would take longer than
    a thousand forces; None where they are not that, or the law is a table."""
    try:
        shape = arrays[0].shape
        count, = shape
        places = []
        for array in arrays:
            if array.shape != shape or array.dtype is not float64:
                return None
            places.append(address_of(buffer_of(array)))
        if out is None:
            # One block: the allocator keeps it for the next call. Of two it gives the memory back each time, and getting
            # it anew costs more than the forces.
            block = _empty((2, count))
            first = address_of(buffer_of(block))
            one, other, second = block[0], block[1], first + 8 * count
        else:
            one, other = out
            if one.dtype is not float64 or other.dtype is not float64 or not one.shape == other.shape == shape:
                return None
            first, second = address_of(buffer_of(one)), address_of(buffer_of(other))
        status = function(_formulas[law], bearing._address, count, *places, first, second)
    except _not_gapless:
        return None
    check(status)
    return one, other


def polar_force(law: str, bearing: Bearing, eccentricity_ratio: ArrayLike, slip_rate: ArrayLike,
                squeeze_rate: ArrayLike, out: Optional[Sequence[NDArray[numpy.float64]]] = None) -> tuple[Number, Number]:
    """Radial and tangential force of the film on the journal [N].

    short_half, for one: F_r/S = -(eps |a|/q^2 + pi b (1 + 2 eps^2)/(2 q^(5/2))), S = mu R L^3/c^2, q = 1 - eps^2.
    Source: Flores et al. (2009), eqs. 8 and 9; every law's formula and source stand in its header and in data/README.md.

    law                 a name of laws()
    eccentricity_ratio  eps = e/c, from 0 to below 1
    slip_rate           a = eps (omega_J + omega_B - 2 attitude rate) [1/s]
    squeeze_rate        b, the rate of eps [1/s]
    out                 two float64 arrays to be written, of the common shape; made anew if left out

    finite_full, finite_half, finite_dynamic and finite_reynolds are Reynolds' equation for the bearing's own L/D, from a
    table: film_table() says how accurate; where there is none yet it is compiled, which takes a while once.

    The three broadcast against each other. Returns the pair (radial, tangential): along the eccentricity, and 90
    degrees counter-clockwise of it. ValueError for an unknown law or a row without a film (it is named), OverflowError
    beyond double precision. The error is a few roundings (README, "How accurate").

    >>> bearing = Bearing(viscosity=0.4, length=0.04, radius=0.0098, clearance=2e-4)
    >>> radial, tangential = polar_force("short_dynamic", bearing, 0.5, 2, 1)
    >>> print(f"{radial:.10f} {tangential:.10f}")
    -58.0961230514 22.2900063156
    >>> finite = polar_force("finite_reynolds", bearing, 0.5, 2, 1)  # the film of the real length, L/D 2.04
    >>> print(f"{finite[0]:.1f} {finite[1]:.1f}")
    -13.6 6.7
    >>> polar_force("short_half", bearing, [[0.1], [0.2]], 1, [0, 1, 2])[0].shape
    (2, 3)
    """
    forces = _gapless(_polar_force, law, bearing, (eccentricity_ratio, slip_rate, squeeze_rate), out)
    if forces is not None:
        return forces
    batch = Batch([eccentricity_ratio, slip_rate, squeeze_rate], out)
    call(library.lubjoint_polar_force, law, bearing, batch.count, *batch.inputs, *batch.outputs)
    warn_beyond(law, bearing, eccentricity_ratio)
    return batch.answers()


def journal_force(law: str, bearing: Bearing, ex: ArrayLike, ey: ArrayLike, vx: ArrayLike, vy: ArrayLike,
                  omega_bearing: ArrayLike, omega_journal: ArrayLike,
                  out: Optional[Sequence[NDArray[numpy.float64]]] = None) -> tuple[Number, Number]:
    """Force of the film on the journal [N]: fx, fy, in the inertial frame of the motion.

    F = F_r r + F_t t with r = e/|e|, t 90 degrees counter-clockwise of it, b = v.r/c and
    a = eps (omega_J + omega_B) - 2 v.t/c. Source: Flores et al. (2009), eq. 19, of the law's radial and tangential force.

    ex, ey   the journal's centre minus the bearing's [m];  vx, vy  its inertial rate [m/s]
    omega_bearing, omega_journal  absolute spins [rad/s]

    All broadcast; the pair has their common shape. At e = 0 the radial direction is that of v. ValueError and
    OverflowError as of polar_force.

    >>> bearing = Bearing(viscosity=0.4, length=0.04, radius=0.0098, clearance=2e-4)
    >>> fx, fy = journal_force("short_half", bearing, 1e-4, 0, 0, 0, 0, 50)  # steady, at half the clearance
    >>> fx < 0 < fy
    True
    """
    forces = _gapless(_journal_force, law, bearing, (ex, ey, vx, vy, omega_bearing, omega_journal), out)
    if forces is not None:
        return forces
    batch = Batch([ex, ey, vx, vy, omega_bearing, omega_journal], out)
    call(library.lubjoint_journal_force, law, bearing, batch.count, MotionStruct(*batch.inputs), *batch.outputs)
    warn_beyond(law, bearing, ex, ey)
    return batch.answers()


@dataclass(frozen=True)
class ForceJacobian:
    """Force on the journal [N] and its derivatives at given spins, by_place [N/m] and by_velocity [N s/m], of shape
    (..., 2, 2): the first index is the force's direction, the second that of the displacement or the velocity."""

    fx: Number
    fy: Number
    by_place: NDArray[numpy.float64]
    by_velocity: NDArray[numpy.float64]


def force_jacobian(law: str, bearing: Bearing, ex: ArrayLike, ey: ArrayLike, vx: ArrayLike, vy: ArrayLike,
                   omega_bearing: ArrayLike, omega_journal: ArrayLike) -> ForceJacobian:
    """Force of the film on the journal and its exact derivatives by e and v, whatever the motion.

    With e = c e^ and u = (v - (omega_J + omega_B)/2 e_perp)/c the chain rule of F = S f(e^, u), f differentiated with
    dual numbers: exact to rounding, of a compiled law as exact as its table's slopes. K = -by_place, C = -by_velocity.
    Source: the laws' own formulas (as of polar_force) on dual numbers; no formula of a derivative is written down.

    Motion as of journal_force, [m], [m/s], [rad/s]; all broadcast, and the matrices are of shape (..., 2, 2). At rest, and
    where a half film jumps, the derivatives are those of one side. ValueError for an unknown law or a row without a film
    (it is named), OverflowError beyond double precision.

    >>> bearing = Bearing(viscosity=0.02, length=0.05, radius=0.05, clearance=5e-5)
    >>> rest = equilibrium("finite_reynolds", bearing, 5000, 314.159)
    >>> e, phi = bearing.clearance * rest.eccentricity_ratio, rest.attitude
    >>> slopes = force_jacobian("finite_reynolds", bearing, e * numpy.cos(phi), e * numpy.sin(phi), 0, 0, 0, 314.159)
    >>> known = coefficients("finite_reynolds", bearing, 314.159, load=5000)  # x along the load, as here
    >>> bool(numpy.allclose(-slopes.by_place, known.stiffness, rtol=1e-9))
    True
    """
    batch = Batch([ex, ey, vx, vy, omega_bearing, omega_journal], None, 10)
    to = batch.outputs
    call(library.lubjoint_force_jacobian, law, bearing, batch.count, MotionStruct(*batch.inputs),
         JacobianStruct(to[0], to[1], (4 * Array)(*to[2:6]), (4 * Array)(*to[6:10])))
    warn_beyond(law, bearing, ex, ey)
    fx, fy = batch.answers()[:2]
    return ForceJacobian(fx, fy, batch.matrices(2), batch.matrices(6))


def transition_force(law: str, bearing: Bearing, contact: Contact, ex: ArrayLike, ey: ArrayLike, vx: ArrayLike,
                     vy: ArrayLike, omega_bearing: ArrayLike, omega_journal: ArrayLike,
                     out: Optional[Sequence[NDArray[numpy.float64]]] = None) -> tuple[Number, Number]:
    """Force on a journal that may touch the wall [N]: film up to e = c, a blend over e0, dry contact beyond.

    F = ((c + e0 - |e|) F_film - (|e| - c) F_N r)/e0 in the blend, the film's clearance being c + e1 throughout, and
    F_N = K delta^(3/2) (1 + 3(1 - c_r^2) rate/(4 impact speed)), delta = |e| - c, never pulling. Source: Flores et al.
    (2009), eq. 20, and Lankarani and Nikravesh (1990).

    Arguments as of journal_force; all broadcast, and the pair has their common shape. Defined for any eccentricity.
    ValueError for an unknown law or a Contact whose numbers are not allowed, OverflowError beyond double precision.

    >>> bearing = Bearing(viscosity=0.04, length=0.04, radius=0.01, clearance=2e-4)
    >>> contact = Contact(e0=4e-6, e1=2e-5, stiffness=1e10, restitution=0.9, impact_speed=0.1)
    >>> fx, fy = transition_force("long_half", bearing, contact, 3e-4, 0, 0, 0, 0, 0)
    >>> print(f"{fx:.1f} N")
    -10000.0 N
    """
    batch = Batch([ex, ey, vx, vy, omega_bearing, omega_journal], out)
    call(library.lubjoint_transition_force, law, bearing, contact._struct(), batch.count, MotionStruct(*batch.inputs),
         *batch.outputs)
    # The film's clearance is wider, and beyond c + e0 there is no film.
    film = dataclasses.replace(bearing, clearance=bearing.clearance + contact.e1)
    ratio = numpy.minimum(numpy.hypot(ex, ey), bearing.clearance + contact.e0) / film.clearance
    warn_beyond(law, film, ratio)
    return batch.answers()


def joint_moments(ex: ArrayLike, ey: ArrayLike, sx_i: ArrayLike, sy_i: ArrayLike, sx_j: ArrayLike, sy_j: ArrayLike,
                  fx: ArrayLike, fy: ArrayLike,
                  out: Optional[Sequence[NDArray[numpy.float64]]] = None) -> tuple[Number, Number]:
    """Moments [N m] about the mass centres of the bearing's body i and the journal's body j, of a force on the journal.

    M_i = -s_i x F - e x F and M_j = s_j x F: -F acts on body i at the journal's centre. Source: Flores et al. (2009),
    eqs. 33 and 34.

    ex, ey         the journal's centre minus the bearing's [m];  fx, fy  on the journal [N]
    sx_i ... sy_j  the arms from the mass centres to the joint's centres [m]

    All broadcast; the pair has their common shape. ValueError for shapes that don't broadcast, OverflowError for a moment
    that is no finite number. The error is a few roundings of the products.

    >>> joint_moments(0, 0, 0.1, 0, -0.1, 0, 0, 3)
    (-0.30000000000000004, -0.30000000000000004)
    """
    batch = Batch([ex, ey, sx_i, sy_i, sx_j, sy_j, fx, fy], out)
    check(library.lubjoint_joint_moments(batch.count, *batch.inputs, *batch.outputs))
    return batch.answers()
