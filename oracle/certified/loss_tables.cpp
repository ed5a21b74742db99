#include "oracle/certified/film_coefficients.hpp"
#include "oracle/certified/film_losses.hpp"
#include "oracle/certified/golden_states.hpp"
#include "oracle/certified/golden_table.hpp"
#include "oracle/certified/overlap.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::certified {

namespace {

/// A number that is not defined: two empty fields.
const std::vector<CertifiedNumber> undefined = {{"", ""}};

/// Torques or a flow may be zero by symmetry, and then have no size to be compared with: that of their terms stands
/// beside them.
std::vector<Ball> torques(const LossBalls& losses, const Ball& size) {
  return {losses.torque_journal, losses.torque_bearing, size};
}

void check_losses(const LawEntry& law, const JointState& state, std::size_t number) {
  if (!law.has_pressure) return;  // its torques and power are definitions
  const std::string where = "losses of " + std::string(law.name) + " at state " + std::to_string(number);
  const auto moment = [&] {  // c|F|
    const PlaneBalls force = film_force(law, state, Ball(state.clearance)).force;
    return Ball(state.clearance) * sqrt(force.x * force.x + force.y * force.y);
  };
  require_overlap([&] { return torques(film_losses(law, state), moment()); },
                  [&] { return torques(film_losses_by_quadrature(law, state), moment()); }, where + ", torques");
  require_overlap([&] { return std::vector<Ball>{film_losses(law, state).power}; },
                  [&] { return std::vector<Ball>{film_losses_by_quadrature(law, state).power}; }, where + ", power");
  if (!law.is_short) return;
  const auto flow = [&] {  // cRL(|a| + |b|)
    const FilmBalls film = film_seen(law, film_frame(state, Ball(state.clearance)).film);
    return Ball(state.clearance) * Ball(state.radius) * Ball(state.length) * (abs(film.a) + abs(film.b));
  };
  require_overlap(
      [&] {
        return std::vector<Ball>{*film_losses(law, state).side_flow, flow()};
      },
      [&] {
        return std::vector<Ball>{*film_losses_by_quadrature(law, state).side_flow, flow()};
      },
      where + ", side flow");
}

std::vector<Ball> in_order(const CoefficientBalls& m) {
  return {m.krr, m.krt, m.ktr, m.ktt, m.crr, m.crt, m.ctr, m.ctt};
}

std::vector<SteadyState> steady_states() {
  std::vector<SteadyState> states;
  for (const BearingValues& values : bearings) {
    for (const double epsilon : {1e-9, 0.001, 0.0625, 0.25, 0.266272, 0.5, 0.75, 0.875, 0.96875, 0.999, 1 - 1e-9}) {
      for (const double omega : {52.35987755982989, -157.1}) {
        states.push_back({values.viscosity, values.length, values.radius, values.clearance, epsilon, omega});
      }
    }
  }
  return states;
}

/// Is there a mass from which on the rotor is unstable, and a whirl there?
bool has_threshold(const LawEntry& law, const SteadyState& state) {
  const WorkingPrecision precision(192);
  const SteadyBalls rest = steady_state(law, state);
  return arb_is_positive(rest.kappa_ratio.get()) && arb_is_positive(rest.whirl_square.get());
}

}  // namespace

GoldenTable film_losses_table() {
  const std::vector<WrenchState> states = wrench_states();
  const auto row = [states](std::size_t number) {
    const LawEntry& law = laws[number / states.size()];
    const JointState& joint = states[number % states.size()].joint;
    check_losses(law, joint, number % states.size());
    const auto losses = certify([&] {
      const LossBalls balls = film_losses(law, joint);
      std::vector<Ball> values{balls.torque_journal, balls.torque_bearing, balls.power};
      if (balls.side_flow) values.push_back(*balls.side_flow);
      return values;
    });
    RowText text;
    text.add(law.name).add(joint.viscosity).add(joint.length).add(joint.radius).add(joint.clearance);
    text.add(joint.omega_bearing).add(joint.omega_journal).add(joint.ex).add(joint.ey).add(joint.vx).add(joint.vy);
    text.add(losses);
    if (!law.is_short) text.add(undefined);
    return text.take();
  };
  return {"film_losses.csv",
          golden_header("law,viscosity,length,radius,clearance,omega_bearing,omega_journal,ex,ey,vx,vy",
                        {"torque_journal", "torque_bearing", "power", "side_flow"}),
          laws.size() * states.size(), row};
}

GoldenTable coefficients_table() {
  const std::vector<SteadyState> states = steady_states();
  const auto row = [states](std::size_t number) {
    const LawEntry& law = laws[number / states.size()];
    const SteadyState& state = states[number % states.size()];
    if (law.has_pressure) {
      const Ball epsilon(state.epsilon);
      require_overlap([&] { return in_order(coefficients(law.law, epsilon)); },
                      [&] { return in_order(coefficients_by_quadrature(law.law, epsilon)); },
                      "coefficients of " + std::string(law.name) + " at ε " + reports::number(state.epsilon));
    }
    const auto rest = certify([&] {
      const SteadyBalls b = steady_state(law, state);
      return std::vector<Ball>{b.load, b.attitude, b.kxx, b.kxy, b.kyx, b.kyy, b.cxx, b.cxy, b.cyx, b.cyy};
    });
    RowText text;
    text.add(law.name).add(state.viscosity).add(state.length).add(state.radius).add(state.clearance);
    text.add(state.epsilon).add(state.omega).add(rest);
    if (!has_threshold(law, state)) return text.add(undefined).add(undefined).take();
    return text
        .add(certify([&] {
          const SteadyBalls b = steady_state(law, state);
          return std::vector<Ball>{b.critical_mass, sqrt(b.whirl_square)};
        }))
        .take();
  };
  return {"coefficients.csv",
          golden_header("law,viscosity,length,radius,clearance,eccentricity_ratio,omega",
                        {"load", "attitude", "kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy", "critical_mass",
                         "whirl_ratio"}),
          laws_at_rest * states.size(), row};
}

GoldenTable loaded_coefficients_table() {
  const std::vector<LoadedJournal> journals = loaded_journals();
  const auto row = [journals](std::size_t number) {
    const LawEntry& law = laws[number / journals.size()];
    const LoadedJournal& journal = journals[number % journals.size()];
    if (law.has_pressure) {
      require_overlap([&] { return in_order(coefficients(law.law, loaded_ratio(law, journal))); },
                      [&] { return in_order(coefficients_by_quadrature(law.law, loaded_ratio(law, journal))); },
                      "coefficients of " + std::string(law.name) + " under " + reports::number(journal.load) + " N");
    }
    const auto rest = certify([&] {
      const Ball epsilon = loaded_ratio(law, journal);
      const SteadyBalls b = loaded_state(law, journal, epsilon);
      return std::vector<Ball>{epsilon, b.attitude, b.kxx, b.kxy, b.kyx, b.kyy, b.cxx, b.cxy, b.cyx, b.cyy};
    });
    RowText text;
    text.add(law.name).add(journal.viscosity).add(journal.length).add(journal.radius).add(journal.clearance);
    return text.add(journal.omega).add(journal.load).add(rest).take();
  };
  return {"loaded_coefficients.csv",
          golden_header("law,viscosity,length,radius,clearance,omega,load",
                        {"eccentricity_ratio", "attitude", "kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"}),
          laws_at_rest * journals.size(), row};
}

}  // namespace lubjoint::certified
