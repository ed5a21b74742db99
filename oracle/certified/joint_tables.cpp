#include "oracle/certified/golden_states.hpp"
#include "oracle/certified/golden_table.hpp"

namespace lubjoint::certified {

namespace {

constexpr std::string_view joint_columns = "viscosity,length,radius,clearance,omega_bearing,omega_journal,ex,ey,vx,vy";
constexpr std::string_view contact_columns = "e0,e1,contact_stiffness,restitution,impact_speed";

void add_joint(RowText& text, const JointState& state) {
  for (const double value : {state.viscosity, state.length, state.radius, state.clearance, state.omega_bearing,
                             state.omega_journal, state.ex, state.ey, state.vx, state.vy}) {
    text.add(value);
  }
}

struct StiffnessState {
  double radius, clearance, modulus_bearing, poisson_bearing, modulus_journal, poisson_journal;
};

}  // namespace

GoldenTable joint_wrench_table() {
  const std::vector<WrenchState> states = wrench_states();
  const auto row = [states](std::size_t number) {
    const LawEntry& law = laws[number / states.size()];
    const auto& [joint, arms] = states[number % states.size()];
    const auto wrench = certify([&, &joint = joint, &arms = arms] {
      const WrenchBalls balls = joint_wrench(law, joint, arms);
      return std::vector<Ball>{balls.force.x, balls.force.y, balls.moment_bearing, balls.moment_journal};
    });
    RowText text;
    text.add(law.name);
    add_joint(text, joint);
    for (const double arm : {arms.sx_i, arms.sy_i, arms.sx_j, arms.sy_j}) text.add(arm);
    return text.add(wrench).take();
  };
  return {"joint_wrench.csv",
          golden_header("law," + std::string(joint_columns) + ",sx_i,sy_i,sx_j,sy_j",
                        {"fx", "fy", "mz_bearing", "mz_journal"}),
          laws.size() * states.size(), row};
}

GoldenTable transition_table() {
  const std::vector<TransitionState> states = transition_states();
  const auto row = [states](std::size_t number) {
    const LawEntry& law = laws[number / states.size()];
    const auto& [joint, contact] = states[number % states.size()];
    const auto force = certify([&, &joint = joint, &contact = contact] {
      const PlaneBalls balls = transition_force(law, joint, contact);
      return std::vector<Ball>{balls.x, balls.y};
    });
    RowText text;
    text.add(law.name);
    add_joint(text, joint);
    text.add(contact.e0).add(contact.e1).add(contact.stiffness).add(contact.restitution).add(contact.impact_speed);
    return text.add(force).take();
  };
  return {"transition.csv",
          golden_header("law," + std::string(joint_columns) + "," + std::string(contact_columns), {"fx", "fy"}),
          laws.size() * states.size(), row};
}

GoldenTable dry_contact_table() {
  const std::vector<TransitionState> states = transition_states();
  const auto row = [states](std::size_t number) {
    const auto& [joint, contact] = states[number];
    const auto force = certify([&, &joint = joint, &contact = contact] {
      const PlaneBalls balls = dry_force(joint, contact);
      return std::vector<Ball>{balls.x, balls.y};
    });
    RowText text;
    text.add(joint.clearance).add(joint.ex).add(joint.ey).add(joint.vx).add(joint.vy);
    text.add(contact.stiffness).add(contact.restitution).add(contact.impact_speed);
    return text.add(force).take();
  };
  return {"dry_contact.csv",
          golden_header("clearance,ex,ey,vx,vy,contact_stiffness,restitution,impact_speed", {"fx", "fy"}),
          states.size(), row};
}

GoldenTable contact_stiffness_table() {
  static constexpr std::array<StiffnessState, 6> states = {{{0.0098, 0.0002, 2.07e11, 0.3, 2.07e11, 0.3},
                                                            {0.015625, 0x1p-13, 2e11, 0.25, 1e11, 0.375},
                                                            {0.05, 5e-05, 2.1e11, 0.29, 7e10, 0.33},
                                                            {0.01, 2e-05, 1.1e11, 0.34, 2.1e11, 0.28},
                                                            {0.5, 0.25, 3e9, 0.4, 2e11, 0.3},
                                                            {0.002, 1e-06, 2e11, 0, 2e11, 0.5}}};
  const auto row = [](std::size_t number) {
    const StiffnessState& s = states[number];
    const auto value = certify([&] {
      return std::vector<Ball>{contact_stiffness(s.radius, s.clearance, s.modulus_bearing, s.poisson_bearing,
                                                 s.modulus_journal, s.poisson_journal)};
    });
    RowText text;
    text.add(s.radius).add(s.clearance).add(s.modulus_bearing).add(s.poisson_bearing);
    return text.add(s.modulus_journal).add(s.poisson_journal).add(value).take();
  };
  return {"contact_stiffness.csv",
          golden_header("radius,clearance,modulus_bearing,poisson_bearing,modulus_journal,poisson_journal",
                        {"contact_stiffness"}),
          states.size(), row};
}

GoldenTable exit_speed_table() {
  static constexpr std::array<double, 4> speeds = {0.001, 0.125, 0.5, 10};
  static constexpr std::array<double, 7> restitutions = {0, 0.1, 0.25, 0.5, 0.75, 0.9, 0.999};
  const auto row = [](std::size_t number) {
    const double speed = speeds[number / restitutions.size()];
    const double restitution = restitutions[number % restitutions.size()];
    const auto value = certify([&] { return std::vector<Ball>{exit_speed(speed, restitution)}; });
    return RowText().add(speed).add(restitution).add(value).take();
  };
  return {"contact_exit_speed.csv", golden_header("impact_speed,restitution", {"exit_speed"}),
          speeds.size() * restitutions.size(), row};
}

GoldenTable equilibrium_table() {
  const std::vector<EquilibriumState> states = equilibrium_states();
  const auto row = [states](std::size_t number) {
    const LawEntry& law = laws[number / states.size()];
    const EquilibriumState& state = states[number % states.size()];
    const auto value = certify([&] {
      const EquilibriumBalls balls = equilibrium(law, state);
      return std::vector<Ball>{balls.eccentricity_ratio, balls.ex_over_c, balls.ey_over_c, balls.attitude};
    });
    RowText text;
    text.add(law.name).add(state.viscosity).add(state.length).add(state.radius).add(state.clearance);
    return text.add(state.omega_sum).add(state.load_x).add(state.load_y).add(value).take();
  };
  return {"equilibrium.csv",
          golden_header("law,viscosity,length,radius,clearance,omega_sum,load_x,load_y",
                        {"eccentricity_ratio", "ex_over_c", "ey_over_c", "attitude"}),
          laws_at_rest * states.size(), row};
}

}  // namespace lubjoint::certified
