/// A multibody system as the integrators see it.
#pragma once

#include <vector>

#include "lubjoint/motion/energy_balance.hpp"
#include "lubjoint/motion/multibody_results.hpp"
#include "lubjoint/multibody/planar_system.hpp"
#include "lubjoint/ode/exact_jacobian.hpp"
#include "lubjoint/ode/integrator.hpp"

namespace lubjoint {

/// y = (q, q̇) and, with a ledger, the work of each term;  ẏ = (q̇, q̈, powers).
template <class R>
class MultibodyOde final : public OdeSystem<R, run_time_size> {
 public:
  using State = std::vector<R>;                   ///< y
  using Jacobian = JacobianOf<R, run_time_size>;  ///< ∂ẏ/∂y
  static constexpr int jacobian_group = 6;        ///< columns of the Jacobian a pass: those of a body
  /// A number with the derivatives of one pass.
  using Seeded = Dual<R, jacobian_group>;

  /// @param with_ledger  integrate the work of each term, too
  MultibodyOde(const PlanarSystem<R>& system, bool with_ledger);

  const PlanarSystem<R>& system() const { return system_; }                    ///< whose equations these are
  bool with_ledger() const { return with_ledger_; }                            ///< is the work integrated?
  bool has_contact() const { return has_contact_; }                            ///< may any joint touch?
  std::size_t mechanical_states() const { return 2 * system_.coordinates(); }  ///< of (q, q̇)
  /// Number of states.
  std::size_t dimension() const { return mechanical_states() + (with_ledger_ ? works() : 0); }
  /// Number of terms of a ledger.
  std::size_t works() const { return ledger_terms + (system_.elements().has_dampers() ? 1 : 0); }
  std::size_t evaluations() const { return evaluations_; }  ///< of ẏ, so far
  /// Leaves out of the count what was evaluated since it was at n: looks at a run are none of its cost.
  void count_from(std::size_t n) { evaluations_ = n; }

  /// Memories of the joints; empty where nothing can touch and no film jumps.
  std::vector<JointMemory<R>>& memory() { return memory_; }
  const std::vector<JointMemory<R>>& memory() const { return memory_; }  ///< likewise

  /// Of the tables of moving loads, one a load. Equations that are integrated read those that are held; looks at a
  /// state read what it says.
  std::vector<TablePiece>& table_pieces() { return table_pieces_; }
  const std::vector<TablePiece>& table_pieces() const { return table_pieces_; }  ///< likewise

  /// ẏ; counted.
  void rate(const State& y, State& dydt, const R& t) override;
  /// ∂ẏ/∂y, exact.
  void jacobian(const State& y, Jacobian& j, const R& t) override;
  /// ∂ẏ/∂t, exact.
  void time_slope(const State& y, State& slope, const R& t) override;

  /// e·ė of each joint whose film kinks where it closes and opens.
  void kinks(const State& y, const R& t, std::vector<R>& values) override {
    values.clear();
    for (std::size_t j = 0; j < system_.joints().size(); ++j) {
      if (!system_.joints()[j].kinks()) continue;
      if (values.empty()) system_.evaluate_kinematics(t, y.data(), real_);
      const JournalMotion<R> motion = system_.journal_motion(j, real_);
      values.push_back(dot(motion.eccentricity, motion.velocity));
    }
  }

  /// Everything at a state: joints, multipliers, rows. With the memory given, else the current one.
  const SystemWorkspace<R>& at(const R& t, const State& y) { return at(t, y, memory_); }
  /// The same, with another memory.
  const SystemWorkspace<R>& at(const R& t, const State& y, const std::vector<JointMemory<R>>& memory);

  SystemWorkspace<R>& workspace() { return real_; }  ///< of the last evaluation

  /// ½q̇ᵀMq̇, and the potential energy −Σ m g·r, with that of springs. @throws SpringWithoutDirection
  MechanicalEnergy<R> energy(const State& y) const {
    MechanicalEnergy<R> sum{R(0), R(0)};
    const std::size_t n = system_.coordinates();
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) {
      const PlanarBody<R>& body = system_.bodies()[b];
      const R* q = y.data() + 3 * b;
      const R* v = y.data() + n + 3 * b;
      sum.kinetic += (body.mass * (v[0] * v[0] + v[1] * v[1]) + body.inertia * v[2] * v[2]) / 2;
      sum.potential -= body.mass * (system_.gravity().x() * q[0] + system_.gravity().y() * q[1]);
    }
    if (!system_.elements().springs.empty()) {
      sum.potential += system_.elements().template energy<R>([&](std::size_t body) {
        if (body == ground_body) return PlanarFrame<R>(ground_motion<R>());
        const R* q = y.data() + 3 * body;
        const R* v = q + n;
        return PlanarFrame<R>({Vector2<R>(q[0], q[1]), q[2], Vector2<R>(v[0], v[1]), v[2]});
      });
    }
    return sum;
  }

  /// Powers of the terms of a ledger, of an evaluated workspace.
  /// @param y  (q, q̇);  @param power  works() numbers
  template <class T, class Time>
  void fill_powers(const Time& t, const std::vector<T>& y, const SystemWorkspace<T>& w, T* power) const {
    const std::size_t n = system_.coordinates();
    for (std::size_t i = 0; i < ledger_terms; ++i) power[i] = T(0);
    const auto add = [&](LedgerTerm term, const T& value) { power[static_cast<std::size_t>(term)] += value; };
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) {
      const PlanarBody<R>& body = system_.bodies()[b];
      const T* v = &y[n + 3 * b];
      add(LedgerTerm::loads, T(body.load.x() * v[0] + body.load.y() * v[1] + body.moment * v[2]));
    }
    if (system_.has_elements()) add_element_powers(t, w, power);
    for (const JointForce<T>& joint : w.joints) {
      add(LedgerTerm::film, joint.film_power());
      if (has_contact_) add(LedgerTerm::contact, joint.contact_power());
    }
    for (std::size_t k = 0; k < w.shear_torques.size(); ++k) {
      const JournalMotion<T>& motion = w.joints[system_.sheared_joints()[k]].kinematics.motion;
      add(LedgerTerm::film, T(w.shear_torques[k] * (motion.journal_spin - motion.bearing_spin)));
    }
    for (std::size_t c = 0; c < system_.constraints().size(); ++c) {
      const LedgerTerm term = system_.constraints()[c].is_driver() ? LedgerTerm::drivers : LedgerTerm::constraints;
      for (std::size_t row = system_.first_row(c); row < system_.first_row(c + 1); ++row) {
        add(term, T(-w.multipliers[row] * (system_.constraint_rate(row, w) - w.rows[row].time_rate)));
      }
    }
  }

 private:
  template <class T, class Time>
  void fill(const Time& t, const std::vector<T>& y, std::vector<T>& dydt, SystemWorkspace<T>& w) const {
    w.table_pieces = &table_pieces_;
    system_.evaluate(t, y.data(), memory_, w);
    const std::size_t n = system_.coordinates();
    for (std::size_t i = 0; i < n; ++i) {
      dydt[i] = y[n + i];
      dydt[n + i] = w.accelerations[i];
    }
    if (with_ledger_) fill_powers(t, y, w, &dydt[2 * n]);
  }

  /// Powers of moving loads and of dampers. Not inlined, as what systems without them leave out.
  template <class T, class Time>
  [[gnu::noinline]] void add_element_powers(const Time& t, const SystemWorkspace<T>& w, T* power) const {
    const ForceElements<R>& elements = system_.elements();
    const auto frame = [&](std::size_t body) -> const PlanarFrame<T>& { return system_.frame(body, w); };
    power[static_cast<std::size_t>(LedgerTerm::loads)] += elements.template load_power<T>(t, frame, w.table_pieces);
    if (elements.has_dampers())
      power[static_cast<std::size_t>(LedgerTerm::dampers)] = elements.template damper_power<T>(frame);
  }

  const PlanarSystem<R>& system_;
  bool with_ledger_;
  bool has_contact_ = false;
  SystemWorkspace<R> real_;
  SystemWorkspace<Seeded> dual_;
  RunTimeJacobian<jacobian_group, R> derivatives_;
  std::vector<JointMemory<R>> memory_;
  std::vector<TablePiece> table_pieces_;
  std::size_t evaluations_ = 0;
};

// Out of the class, where no function is inline: a declaration of an instance (multibody_scene.hpp) then spares those
// who include it the compilation of every law, constraint and solver on numbers with derivatives.

template <class R>
MultibodyOde<R>::MultibodyOde(const PlanarSystem<R>& system, bool with_ledger)
    : system_(system),
      with_ledger_(with_ledger),
      real_(system.template workspace<R>()),
      dual_(system.template workspace<Seeded>()),
      table_pieces_(system.elements().loads.size()) {
  bool jumps = false;
  for (const JointElement<R>& joint : system.joints()) {
    has_contact_ = has_contact_ || joint.has_contact();
    jumps = jumps || joint.has_half_film();
  }
  if (has_contact_ || jumps) memory_.resize(system.joints().size());
}

template <class R>
void MultibodyOde<R>::rate(const State& y, State& dydt, const R& t) {
  ++evaluations_;
  fill(t, y, dydt, real_);
}

template <class R>
void MultibodyOde<R>::jacobian(const State& y, Jacobian& j, const R& t) {
  derivatives_.fill([&](const auto& x, auto& dxdt) { fill(t, x, dxdt, dual_); }, y, mechanical_states(), j);
}

template <class R>
void MultibodyOde<R>::time_slope(const State& y, State& slope, const R& t) {
  derivatives_.fill_time_slope([&](const auto& x, auto& dxdt, const Seeded& s) { fill(s, x, dxdt, dual_); }, y, t,
                               slope);
}

template <class R>
const SystemWorkspace<R>& MultibodyOde<R>::at(const R& t, const State& y, const std::vector<JointMemory<R>>& memory) {
  real_.table_pieces = nullptr;
  system_.evaluate(t, y.data(), memory, real_);
  return real_;
}

}  // namespace lubjoint
