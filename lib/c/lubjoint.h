/* C interface of lubjoint: film forces, contact and moments of lubricated revolute joints, over arrays.
 *
 * Units are SI. No function throws or prints. Each returns 0, or an error number of <errno.h>:
 *   EINVAL  an argument is not allowed: an unknown law, a bearing that can't be, a null pointer
 *   ENOENT  the law is compiled for a length over diameter, and no table for the bearing's was given
 *   EDOM    a row of the arrays has no film: the eccentricity ratio is outside [0, 1), or a number is not finite
 *   ERANGE  a force is beyond the range of double precision
 *   ENOMEM  no memory
 * lubjoint_message() then says what was given and what is allowed. After EDOM and ERANGE the rows before the one that
 * the message names are answered, the others untouched. Calls from several threads don't disturb each other.
 * An array that is written may be one that is read. Arrays without gaps (stride 8) are fastest. */
#ifndef LUBJOINT_H
#define LUBJOINT_H

#include <stddef.h>

#if defined(_WIN32)
#define LUBJOINT_API __declspec(dllexport)
#else
#define LUBJOINT_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* An array that is read: element i is at (const char*)data + i*stride. Any stride goes, also 0: one number for all. */
typedef struct lubjoint_in {
  const double* data; /* element 0 */
  ptrdiff_t stride;   /* in bytes */
} lubjoint_in;

/* An array that is written. */
typedef struct lubjoint_out {
  double* data;     /* element 0 */
  ptrdiff_t stride; /* in bytes */
} lubjoint_out;

/* Bearing and oil; all numbers above 0, clearance below radius. */
typedef struct lubjoint_bearing {
  double viscosity; /* [Pa s] */
  double length;    /* [m] */
  double radius;    /* of the journal [m] */
  double clearance; /* radial [m] */
} lubjoint_bearing;

/* Motion of journals in their bearings, in one inertial frame. */
typedef struct lubjoint_motion {
  lubjoint_in ex;            /* journal's centre minus bearing's, x [m] */
  lubjoint_in ey;            /* y */
  lubjoint_in vx;            /* its inertial rate, x [m/s] */
  lubjoint_in vy;            /* y */
  lubjoint_in omega_bearing; /* absolute spin [rad/s] */
  lubjoint_in omega_journal; /* absolute spin [rad/s] */
} lubjoint_motion;

/* Dry contact and the transition to it: 0 < e0 < e1. */
typedef struct lubjoint_contact {
  double e0;           /* width of the blend [m] */
  double e1;           /* widening of the film's clearance [m] */
  double stiffness;    /* [N/m^1.5] */
  double restitution;  /* from 0 to 1 */
  double impact_speed; /* at which the journal last crossed e = c outwards [m/s], above 0 */
} lubjoint_contact;

/* What the oil costs, to be written. side_flow.data may be null, and must be for a long bearing, which has
 * none, and for a compiled law, which has the force of its film alone. */
typedef struct lubjoint_losses {
  lubjoint_out torque_journal; /* on the journal about its centre [N m] */
  lubjoint_out torque_bearing; /* on the bearing about its centre [N m] */
  lubjoint_out power;          /* lost in the film [W] */
  lubjoint_out side_flow;      /* out of both sides, net [m^3/s] */
} lubjoint_losses;

/* A journal at rest on its film, to be written; x along the load on the journal, y 90 degrees counter-clockwise. */
typedef struct lubjoint_coefficients {
  lubjoint_out load;          /* [N] */
  lubjoint_out attitude;      /* from the load to the eccentricity, positive in the sense of the spin [rad] */
  lubjoint_out stiffness[4];  /* xx, xy, yx, yy [N/m] */
  lubjoint_out damping[4];    /* likewise [N s/m] */
  lubjoint_out critical_mass; /* of a rigid rotor, per bearing [kg]; HUGE_VAL where every mass is stable, 0: none is */
} lubjoint_coefficients;

/* How many velocities carry a force: one; none or two, of half films; a line of them, of laws of the squeeze alone. */
enum lubjoint_mobility_status {
  LUBJOINT_MOBILITY_FOUND = 0,
  LUBJOINT_MOBILITY_NONE = 1,
  LUBJOINT_MOBILITY_TWO = 2,
  LUBJOINT_MOBILITY_MANY = 3
};

/* The velocities that carry a force, to be written. Of two, u is the one with a > 0 and other the one with a < 0; of
 * many, u is the smallest. NaN stands where there is none, and the status says so. */
typedef struct lubjoint_mobility {
  lubjoint_out ux;       /* of the pure squeeze, over the clearance [1/s] */
  lubjoint_out uy;       /* likewise */
  lubjoint_out other_ux; /* likewise; other_ux.data and other_uy.data may be null together */
  lubjoint_out other_uy; /* likewise */
  int* status;           /* n numbers of enum lubjoint_mobility_status, without gaps */
} lubjoint_mobility;

/* What went wrong in this thread's last call that did not return 0; never null. */
LUBJOINT_API const char* lubjoint_message(void);
LUBJOINT_API const char* lubjoint_version(void);

/* Name of law number i from 0 on; null after the last. Laws of the squeeze alone (squeeze_*) bear no journal at rest, and
 * moes_impedance and butenschoen are fits: none of them has film coefficients. butenschoen takes L/D up to 1. The last
 * four, finite_*, are tables: lubjoint_load_film. */
LUBJOINT_API const char* lubjoint_law_name(size_t i);

/* Laws of a film of finite length, finite_full, finite_half, finite_dynamic and finite_reynolds, are tables, each
 * compiled for one length over diameter L/(2R) from 0.05 to 10. A process is given them once, as text or as a file of
 * `lubjoint compile-film`, and after that they are laws like the others in every function here, for bearings of that
 * L/D (to 1e-12) and from all threads. One of the same law and L/D takes the place of the one before.
 * EINVAL: the text is no table, or not all of one (a checksum is part of it). */
LUBJOINT_API int lubjoint_use_film(const char* text);
LUBJOINT_API int lubjoint_load_film(const char* file);

/* What a table says of itself, to be written. */
typedef struct lubjoint_film {
  double length_to_diameter; /* L/(2R) that it was compiled for */
  double ratio_limit; /* eccentricity ratio up to which the error was measured; beyond, it is not known */
  double error;       /* bound of |F - F_solved|/|F| there, F_solved by the solvers of Reynolds' equation */
} lubjoint_film;

/* The table that answers for a law in a bearing. EINVAL: a law that is a formula. */
LUBJOINT_API int lubjoint_film_of(const char* law, const lubjoint_bearing* bearing, lubjoint_film* film);

/* Force of the film on the journal, radial (along the eccentricity) and tangential (90 degrees counter-clockwise), of
 * n states with eccentricity ratio, slip rate a and squeeze rate b [1/s]. */
LUBJOINT_API int lubjoint_polar_force(const char* law, const lubjoint_bearing* bearing, size_t n,
                                      lubjoint_in eccentricity_ratio, lubjoint_in slip_rate, lubjoint_in squeeze_rate,
                                      lubjoint_out radial, lubjoint_out tangential);

/* Force of the film on the journal [N], in the frame of the motion. */
LUBJOINT_API int lubjoint_journal_force(const char* law, const lubjoint_bearing* bearing, size_t n,
                                        const lubjoint_motion* motion, lubjoint_out fx, lubjoint_out fy);

/* The same two for arrays without gaps, each of n numbers: from a language in which making the structures takes longer
 * than a thousand forces. */
LUBJOINT_API int lubjoint_polar_force_gapless(const char* law, const lubjoint_bearing* bearing, size_t n,
                                              const double* eccentricity_ratio, const double* slip_rate,
                                              const double* squeeze_rate, double* radial, double* tangential);
LUBJOINT_API int lubjoint_journal_force_gapless(const char* law, const lubjoint_bearing* bearing, size_t n,
                                                const double* ex, const double* ey, const double* vx, const double* vy,
                                                const double* omega_bearing, const double* omega_journal, double* fx,
                                                double* fy);

/* Force on the journal and its derivatives, to be written. */
typedef struct lubjoint_jacobian {
  lubjoint_out fx;             /* [N] */
  lubjoint_out fy;             /* [N] */
  lubjoint_out by_place[4];    /* dfx/dex, dfx/dey, dfy/dex, dfy/dey [N/m] */
  lubjoint_out by_velocity[4]; /* dfx/dvx, dfx/dvy, dfy/dvx, dfy/dvy [N s/m] */
} lubjoint_jacobian;

/* The same force with its derivatives at given spins: stiffness is minus by_place, damping minus by_velocity. With
 * e = c e^ and u = (v - (omega_journal + omega_bearing)/2 e_perp)/c they are S/c times those of F/S by e^ and u, which
 * are exact to rounding, a compiled law's those of its table. At rest (u = 0), and where a half film jumps, they are
 * those of one side. */
LUBJOINT_API int lubjoint_force_jacobian(const char* law, const lubjoint_bearing* bearing, size_t n,
                                         const lubjoint_motion* motion, const lubjoint_jacobian* jacobian);

/* Friction torques, power and side flow. shear: "film" (where the law's film is), "flooded" or, for half films,
 * "striated"; finite_reynolds, whose table does not know where its film ends, has "flooded" alone. Without it no
 * law resists the spin. */
LUBJOINT_API int lubjoint_film_losses(const char* law, const lubjoint_bearing* bearing, const char* shear, size_t n,
                                      const lubjoint_motion* motion, const lubjoint_losses* losses);

/* Load, attitude, stiffness, damping and critical mass of n journals of spin omega (not 0, of either sign) [rad/s] that
 * rest at an eccentricity ratio above 0 and below 1, in a bearing that does not turn. */
LUBJOINT_API int lubjoint_film_coefficients(const char* law, const lubjoint_bearing* bearing, size_t n,
                                            lubjoint_in eccentricity_ratio, lubjoint_in omega,
                                            const lubjoint_coefficients* coefficients);

/* Where n journals of spin omega (not 0, of either sign) [rad/s] rest under a load (above 0) [N], in a bearing that does
 * not turn: the root of |F(eccentricity ratio)| = load, which grows from 0 to infinity for every law, and the attitude
 * angle from the load to the eccentricity, positive in the sense of the spin [rad]. Good to a few roundings of the
 * load. EDOM: no such place between 1e-300 and 1 - 1e-15. */
LUBJOINT_API int lubjoint_film_equilibrium(const char* law, const lubjoint_bearing* bearing, size_t n, lubjoint_in load,
                                           lubjoint_in omega, lubjoint_out eccentricity_ratio, lubjoint_out attitude);

/* Mobility, the inverse of a law: the pure-squeeze velocity u [1/s] at which the film's force on the journal is (fx, fy)
 * [N], with e/c in the same axes. The journal's own velocity is c u + (omega_journal + omega_bearing)/2 e_perp.
 * butenschoen has none. */
LUBJOINT_API int lubjoint_film_mobility(const char* law, const lubjoint_bearing* bearing, size_t n,
                                        lubjoint_in ex_over_c, lubjoint_in ey_over_c, lubjoint_in fx, lubjoint_in fy,
                                        const lubjoint_mobility* mobility);

/* Force on a journal that may touch the wall [N]: film, blend, dry contact. Defined for any eccentricity. */
LUBJOINT_API int lubjoint_transition_force(const char* law, const lubjoint_bearing* bearing,
                                           const lubjoint_contact* contact, size_t n, const lubjoint_motion* motion,
                                           lubjoint_out fx, lubjoint_out fy);

/* Moments [N m] about the mass centres of the bearing's body i and the journal's body j that a force F on the journal
 * means; -F acts on body i at the journal's centre. sx_i ... sy_j: from the mass centre to the joint's centre [m]. */
LUBJOINT_API int lubjoint_joint_moments(size_t n, lubjoint_in ex, lubjoint_in ey, lubjoint_in sx_i, lubjoint_in sy_i,
                                        lubjoint_in sx_j, lubjoint_in sy_j, lubjoint_in fx, lubjoint_in fy,
                                        lubjoint_out mz_bearing, lubjoint_out mz_journal);

#ifdef __cplusplus
}
#endif

#endif
