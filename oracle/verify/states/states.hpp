/// The states that an implementation is asked about.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "oracle/verify/states/condition.hpp"
#include "oracle/verify/states/solution.hpp"

namespace lubjoint::verify {

/// Where implementations go wrong in different ways. A state is of the first regime, in this order, that it fits:
/// contact: |e| > c;  near_concentric: ε < 0.05;  thin_film: ε > 0.9;  separating: b < 0;  reversing: a < 0;  moderate.
enum class Regime { contact, near_concentric, thin_film, separating, reversing, moderate };
inline constexpr std::array<std::string_view, 6> regime_names = {"contact",    "near-concentric", "thin film",
                                                                 "separating", "reversing",       "moderate"};

Regime regime_of(Quantities quantities, const State& state);
/// Of a journal that rests at ε under a load; reversing where ω < 0.
Regime regime_at_rest(Real ratio, double omega);

/// Designed states: every combination of ε from the centre to 0.9999, signs and zeros of a and b; steady rotation,
/// whirl and squeeze each alone, of both signs, in a bearing that rests and one that turns; for forces, films down to
/// 1 − ε = 3e-10; the seams of the transition; rest. All numbers are exact in single precision, but for films thinner
/// than 5e-5, so that a program in single precision gets the same states. Where a film jumps (a = 0 with the half
/// films), a is zero in any order of operations or far from zero, or the state is left out (Precision::decides). Loads
/// are those at which short_half or long_half rests at ε from 1e-4 to 0.995; losses are asked for at films of 1 − ε ≥
/// 5e-5.
std::vector<State> designed_states(Quantities quantities);

/// Of states at most so many, in their order, chosen so that every regime is there and in each the signs of its rates:
/// one of each kind in turn, the first of them the one in the middle of its kind.
std::vector<State> covering_states(Quantities quantities, std::vector<State> states, std::size_t most);

/// The golden states, the designed ones, and as many seeded random ones; the same on every machine.
/// @param golden  folder of the golden data
/// @param domain  conditions that all states fulfil; random states are drawn until there are enough, or for one that
///                they hardly ever fulfil (a number that is zero) until twenty times as many were tried
/// @throws std::invalid_argument if the golden data can't be read, or no state is left
std::vector<State> states_to_verify(Quantities quantities, const std::filesystem::path& golden, std::size_t random,
                                    std::uint64_t seed, const Conjunction& domain = {});

}  // namespace lubjoint::verify
