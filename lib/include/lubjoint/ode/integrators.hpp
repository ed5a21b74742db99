/// The integrators by name.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "lubjoint/ode/integrator.hpp"

namespace lubjoint {

/// Names of the integrators. `automatic_integrator` is no method of its own: it stands for the choice among them.
inline constexpr std::array<std::string_view, 6> method_names = {
    "radau_iia5", "rosenbrock4", "dopri5", "fehlberg78", "bulirsch_stoer", "adams_bashforth_moulton"};
/// What stands for the choice among them.
inline constexpr std::string_view automatic_integrator = "auto";

/// What a scene or an option may name.
inline constexpr std::array<std::string_view, 7> integrator_names = {
    "radau_iia5", "rosenbrock4", "dopri5", "fehlberg78", "bulirsch_stoer", "adams_bashforth_moulton", "auto"};

/// Is its step length not bound by stability?
constexpr bool is_stiff_integrator(std::string_view name) { return name == "radau_iia5" || name == "rosenbrock4"; }

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
