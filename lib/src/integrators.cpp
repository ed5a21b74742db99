#include "lubjoint/ode/integrators.hpp"

#include <stdexcept>

#include "lubjoint/ode/explicit_integrators.hpp"
#include "lubjoint/ode/odeint_integrators.hpp"
#include "lubjoint/ode/radau_integrator.hpp"
#include "rosenbrock4_integrator.hpp"

namespace lubjoint {

template <std::size_t N>
std::unique_ptr<Integrator<double, N>> make_integrator(std::string_view name,
                                                       const StepTolerance<double, N>& tolerance) {
  if (name == "radau_iia5") return std::make_unique<RadauIntegrator<double, N>>(tolerance);
  if (name == "rosenbrock4") return std::make_unique<detail::Rosenbrock4Integrator<N>>(tolerance);
  if (name == "dopri5") return std::make_unique<Dopri5Integrator<double, N>>(tolerance);
  if (name == "fehlberg78") return std::make_unique<Fehlberg78Integrator<double, N>>(tolerance);
  if (name == "bulirsch_stoer") return std::make_unique<BulirschStoerIntegrator<N>>(tolerance);
  if (name == "adams_bashforth_moulton") return std::make_unique<AdamsIntegrator<N>>(tolerance);
  throw std::invalid_argument("there is no integrator \"" + std::string(name) + "\"");
}

template std::unique_ptr<Integrator<double, 2>> make_integrator(std::string_view, const StepTolerance<double, 2>&);
template std::unique_ptr<Integrator<double, 4>> make_integrator(std::string_view, const StepTolerance<double, 4>&);
template std::unique_ptr<Integrator<double, run_time_size>> make_integrator(
    std::string_view, const StepTolerance<double, run_time_size>&);

}  // namespace lubjoint
