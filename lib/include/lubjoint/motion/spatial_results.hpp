/// What a run of a system in space leaves behind.
#pragma once

#include "lubjoint/motion/multibody_results.hpp"
#include "lubjoint/number/vector3.hpp"

namespace lubjoint {

/// A joint in space at an instant.
struct SpatialJointSample {
  Vector3<double> eccentricity;  ///< e, inertial [m]
  Vector3<double> force;         ///< on the journal, inertial [N]
  double eccentricity_ratio;     ///< ε = |e|/c
  double film_thickness;         ///< c − |e| in the middle plane; negative in contact [m]
  double tilt;                   ///< ψ, between n and ±n_J, the smaller [rad]
  double sliding;                ///< σ, the journal's centre from the middle plane along its axis [m]
  LossSample losses = {};        ///< of a joint with shear
};

/// A system in space at an instant.
struct SpatialSample {
  double t;                                ///< [s]
  std::vector<double> state;               ///< (r, p) of all bodies, then (ṙ, ω′) of all
  std::vector<SpatialJointSample> joints;  ///< in the scene's order
  std::vector<double> driving_efforts;     ///< of each driver on its second body [N m or N]
  std::vector<double> ledger;              ///< kinetic, potential, then the work of each term; empty if not asked for
  std::vector<double> sensors;             ///< every value of every sensor, in the scene's order
};

/// By what a run in space tells what is there from its own errors.
struct SpatialResolution {
  double mechanism;  ///< its size, by which rows of m and of rad are compared [m]
  double length;     ///< tolerance of places [m]
  double angle;      ///< tolerance of angles [rad]
};

/// Peaks of a joint in space.
struct SpatialJointExtremes {
  Peak eccentricity{0, 0};  ///< |e| [m]
  Peak force{0, 0};         ///< |F| [N]
  Peak tilt{0, 0};          ///< ψ; 0 below the tolerance of angles [rad]
  Peak sliding{0, 0};       ///< |σ|; 0 below the tolerance of places [m]
  /// (ψL/2)/(c − |e|), what the tilt takes of the film at the bearing's edge. With a transition to contact, over its
  /// width e₀ where the film is thinner.
  Peak edge_share{0, 0};
};

/// How far Euler parameters and constraints were off at the ends of steps.
struct SpatialDrift : ConstraintDrift {
  double norm = 0;               ///< largest ||p| − 1| before it was normalised
  double left_out_position = 0;  ///< |Φ| of the rows that the equations do without [m or rad]
};

}  // namespace lubjoint
