#include "oracle/certified/joint_forces.hpp"

#include "oracle/certified/root.hpp"

namespace lubjoint::certified {

namespace {

PlaneBalls operator*(const Ball& factor, const PlaneBalls& v) { return {factor * v.x, factor * v.y}; }
PlaneBalls operator+(const PlaneBalls& v, const PlaneBalls& w) { return {v.x + w.x, v.y + w.y}; }

Ball eccentricity(const JointState& state) {
  return sqrt(Ball(state.ex) * Ball(state.ex) + Ball(state.ey) * Ball(state.ey));
}

}  // namespace

FilmFrame film_frame(const JointState& state, const Ball& clearance) {
  const Ball ex(state.ex), ey(state.ey), vx(state.vx), vy(state.vy);
  const Ball square = ex * ex + ey * ey;
  if (square.is_exact_zero()) {
    const Ball speed = sqrt(vx * vx + vy * vy);
    if (speed.is_exact_zero()) return {{}, {Ball(1), Ball(0)}};
    return {{Ball(0), Ball(0), speed / clearance}, {vx / speed, vy / speed}};
  }
  const Ball size = sqrt(square);
  const Ball spins = Ball(state.omega_journal) + Ball(state.omega_bearing);
  const Ball size_c = size * clearance;
  const Ball a = (spins * square - 2 * (ex * vy - ey * vx)) / size_c;
  const Ball b = (ex * vx + ey * vy) / size_c;
  return {{size / clearance, a, b}, {ex / size, ey / size}};
}

FilmForce film_force(const LawEntry& law, const JointState& state, const Ball& clearance) {
  const FilmFrame frame = film_frame(state, clearance);
  const PolarBalls ratio = force_ratio(law.law, frame.film);
  const Ball scale = force_scale(law, state.viscosity, state.length, state.radius, clearance);
  const Ball radial = scale * ratio.radial;
  const Ball tangential = scale * ratio.tangential;
  const PlaneBalls& r = frame.radial;
  return {{radial * r.x - tangential * r.y, radial * r.y + tangential * r.x}, tangential};
}

WrenchBalls joint_wrench(const LawEntry& law, const JointState& state, const JointArms& arms) {
  const auto [force, tangential] = film_force(law, state, Ball(state.clearance));
  const Ball moment_i = Ball(arms.sx_i) * force.y - Ball(arms.sy_i) * force.x;
  const Ball moment_j = Ball(arms.sx_j) * force.y - Ball(arms.sy_j) * force.x;
  return {force, -(moment_i + eccentricity(state) * tangential), moment_j};
}

PlaneBalls dry_force(const JointState& state, const ContactState& contact) {
  const Ball size = eccentricity(state);
  const Ball depth = size - Ball(state.clearance);
  if (depth.sign() <= 0) return {};
  const PlaneBalls r{Ball(state.ex) / size, Ball(state.ey) / size};
  const Ball rate = (Ball(state.ex) * Ball(state.vx) + Ball(state.ey) * Ball(state.vy)) / size;
  const Ball restitution(contact.restitution);
  const Ball damping = 3 * (Ball(1) - restitution * restitution) / 4 * rate / Ball(contact.impact_speed);
  const Ball bracket = Ball(1) + damping;
  if (bracket.sign() <= 0) return {};
  return -(Ball(contact.stiffness) * depth * sqrt(depth) * bracket) * r;
}

PlaneBalls transition_force(const LawEntry& law, const JointState& state, const ContactState& contact) {
  const Ball size = eccentricity(state);
  const Ball c(state.clearance);
  const Ball e0(contact.e0);
  const Ball depth = size - c;
  const Ball remaining = c + e0 - size;
  if (remaining.sign() <= 0) return dry_force(state, contact);
  const PlaneBalls film = film_force(law, state, c + Ball(contact.e1)).force;
  if (depth.sign() <= 0) return film;
  return (remaining / e0) * film + (depth / e0) * dry_force(state, contact);
}

Ball contact_stiffness(double radius, double clearance, double modulus_bearing, double poisson_bearing,
                       double modulus_journal, double poisson_journal) {
  const Ball r_j(radius);
  const Ball c(clearance);
  const auto compliance = [](double modulus, double poisson) {
    return (Ball(1) - Ball(poisson) * Ball(poisson)) / Ball(modulus);
  };
  const Ball both = compliance(modulus_bearing, poisson_bearing) + compliance(modulus_journal, poisson_journal);
  return 4 * sqrt((r_j + c) * r_j / c) / (3 * both);
}

Ball exit_speed(double impact_speed, double restitution) {
  const Ball loss = 3 * (Ball(1) - Ball(restitution) * Ball(restitution)) / 4;  // d δ̇₀
  const Ball kept = loss - log1p(loss);
  // x = d v₁: kept + x + ln(1 − x) falls from a positive value at 0 to −∞ at 1.
  const Ball x = enclosed_root([&](const Ball& place) { return -(kept + place + log1p(-place)); }, Ball(0), Ball(1));
  return x * Ball(impact_speed) / loss;
}

}  // namespace lubjoint::certified
