#include "lubjoint/ode/integrators.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "lubjoint/ode/explicit_integrators.hpp"
#include "lubjoint/ode/odeint_integrators.hpp"
#include "lubjoint/ode/radau_integrator.hpp"
#include "rosenbrock4_integrator.hpp"

namespace lubjoint {

namespace {

template <std::size_t N>
using Made = std::unique_ptr<Integrator<double, N>>;

/// An integrator: its name, its kind, and how it is made for every number of states.
struct Method {
  std::string_view name;
  bool is_stiff;
  Made<2> (*of_two)(const StepTolerance<double, 2>&);
  Made<4> (*of_four)(const StepTolerance<double, 4>&);
  Made<run_time_size> (*of_any)(const StepTolerance<double, run_time_size>&);
};

template <template <std::size_t> class Kind, std::size_t N>
Made<N> make(const StepTolerance<double, N>& tolerance) {
  return std::make_unique<Kind<N>>(tolerance);
}

template <template <std::size_t> class Kind>
constexpr Method method(std::string_view name, bool is_stiff) {
  return {name, is_stiff, make<Kind, 2>, make<Kind, 4>, make<Kind, run_time_size>};
}

template <std::size_t N>
using Radau5 = RadauIntegrator<double, N, 3>;
template <std::size_t N>
using Radau9 = RadauIntegrator<double, N, 5>;
template <std::size_t N>
using Dopri5 = Dopri5Integrator<double, N>;
template <std::size_t N>
using Fehlberg78 = Fehlberg78Integrator<double, N>;

constexpr bool stiff = true;
constexpr bool not_stiff = false;
constexpr std::array methods = {method<Radau5>("radau_iia5", stiff),
                                method<Radau9>("radau_iia9", stiff),
                                method<detail::Rosenbrock4Integrator>("rosenbrock4", stiff),
                                method<Dopri5>("dopri5", not_stiff),
                                method<Fehlberg78>("fehlberg78", not_stiff),
                                method<BulirschStoerIntegrator>("bulirsch_stoer", not_stiff),
                                method<AdamsIntegrator>("adams_bashforth_moulton", not_stiff)};

constexpr auto names = [] {
  std::array<std::string_view, methods.size() + 1> all;
  std::ranges::transform(methods, all.begin(), &Method::name);
  all.back() = automatic_integrator;
  return all;
}();

const Method* method_of(std::string_view name) {
  const auto* found = std::ranges::find(methods, name, &Method::name);
  return found == methods.end() ? nullptr : found;
}

}  // namespace

std::span<const std::string_view> method_names() { return std::span(names).first(methods.size()); }

std::span<const std::string_view> integrator_names() { return names; }

bool is_stiff_integrator(std::string_view name) {
  const Method* method = method_of(name);
  return method && method->is_stiff;
}

template <std::size_t N>
std::unique_ptr<Integrator<double, N>> make_integrator(std::string_view name,
                                                       const StepTolerance<double, N>& tolerance) {
  const Method* method = method_of(name);
  if (!method) throw std::invalid_argument("there is no integrator \"" + std::string(name) + "\"");
  if constexpr (N == 2) {
    return method->of_two(tolerance);
  } else if constexpr (N == 4) {
    return method->of_four(tolerance);
  } else {
    return method->of_any(tolerance);
  }
}

template std::unique_ptr<Integrator<double, 2>> make_integrator(std::string_view, const StepTolerance<double, 2>&);
template std::unique_ptr<Integrator<double, 4>> make_integrator(std::string_view, const StepTolerance<double, 4>&);
template std::unique_ptr<Integrator<double, run_time_size>> make_integrator(
    std::string_view, const StepTolerance<double, run_time_size>&);

}  // namespace lubjoint
