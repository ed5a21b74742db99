/// Conditions on states: a domain that the user declares, and where a program is right, wrong or without a number.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "oracle/verify/states/quantity.hpp"

namespace lubjoint::verify {

/// One number of a state that a condition may speak of.
struct Feature {
  std::string_view name;
  bool has_sign;  ///< compared with zero; the others with thresholds
  /// [rad/s], [1/s], [m], [m/s] or [-]; for states of these quantities
  double (*value)(const State&);
  bool (*is_there)(Quantities);
};

/// omega_sum (ω_J + ω_B), omega_bearing, omega_journal or, in polar quantities, omega; slip_rate a, squeeze_rate b,
/// attitude_rate γ̇, speed |v|, eccentricity_ratio, one_minus_eccentricity_ratio, ex, ey. Zero is zero: parts of the
/// designed states vanish exactly.
const std::vector<Feature>& features();

enum class Comparator { less, less_or_equal, equal, not_equal, greater_or_equal, greater };

/// NAME OP NUMBER
struct Condition {
  const Feature* feature;
  Comparator comparator;
  double threshold;

  bool holds(const State& state) const { return holds_for(feature->value(state)); }
  bool holds_for(double value) const;  ///< of the feature
  std::string words() const;           ///< "omega_sum > 0"
};

/// All of them at once.
using Conjunction = std::vector<Condition>;
bool holds(const Conjunction& conditions, const State& state);
std::string words(const Conjunction& conditions);  ///< "omega_sum > 0 and ex < 0"

/// Reads "omega_sum > 0, eccentricity_ratio >= 0.1".
/// @throws std::invalid_argument that names the part that is wrong, and what is allowed
Conjunction read_conditions(Quantities quantities, std::string_view text);

/// Steady rotation: neither squeeze nor whirl, the bearing at rest.
/// @throws std::invalid_argument for a load, whose states are all steady
Conjunction steady_conditions(Quantities quantities);

/// Any of several conjunctions; none where it is not known.
using Domain = std::vector<Conjunction>;

/// The simplest domain that holds nine states of a set in ten, and of the others none, or if that fails one in two
/// hundred; empty if there is none, or if the set is empty or everything.
/// @param in_set  one entry a state: 1 in the set, 0 not, −1 of no matter
Domain domain_of(Quantities quantities, const std::vector<State>& states, const std::vector<int>& in_set);
std::string words(const Domain& domain);

}  // namespace lubjoint::verify
