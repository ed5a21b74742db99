/// The integrators by name. A new one is a header of its own and a row in lib/src/integrators.cpp.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "lubjoint/ode/integrator.hpp"

namespace lubjoint {

/// Names of the integrators, in the order in which they are listed everywhere.
std::span<const std::string_view> method_names();

/// What stands for the choice among them; no method of its own.
inline constexpr std::string_view automatic_integrator = "auto";

/// What a scene or an option may name: the integrators and auto.
std::span<const std::string_view> integrator_names();

/// Is its step length not bound by stability?
bool is_stiff_integrator(std::string_view name);

/// An integrator for 2 or 4 states, or (run_time_size) as many as its tolerances; compiled in the scene library.
/// @throws std::invalid_argument for a name that is none of method_names
template <std::size_t N>
std::unique_ptr<Integrator<double, N>> make_integrator(std::string_view name,
                                                       const StepTolerance<double, N>& tolerance);

/// Two states: a journal that slides on a = 0.
extern template std::unique_ptr<Integrator<double, 2>> make_integrator(std::string_view,
                                                                       const StepTolerance<double, 2>&);
/// Four states: a free journal.
extern template std::unique_ptr<Integrator<double, 4>> make_integrator(std::string_view,
                                                                       const StepTolerance<double, 4>&);
/// A multibody system.
extern template std::unique_ptr<Integrator<double, run_time_size>> make_integrator(
    std::string_view, const StepTolerance<double, run_time_size>&);

}  // namespace lubjoint
