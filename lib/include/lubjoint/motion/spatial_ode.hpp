/// A system in space as the integrators see it.
#pragma once

#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/motion/spatial_results.hpp"
#include "lubjoint/multibody/spatial/system.hpp"

namespace lubjoint {

/// y = (r, p; ṙ, ω′) and, with a ledger, the work of each term;  ẏ = (ṙ, ½Lᵀω′; r̈, ω̇′, powers).
template <class R>
class SpatialOde final : public OdeSystem<R, run_time_size> {
 public:
  using State = std::vector<R>;                                            ///< y
  using Jacobian = JacobianOf<R, run_time_size>;                           ///< ∂ẏ/∂y
  static constexpr int jacobian_group = static_cast<int>(spatial_states);  ///< columns of the Jacobian: a body's
  /// A number with the derivatives of one pass.
  using Seeded = Dual<R, jacobian_group>;

  /// @param system  kept by reference;  @param with_ledger  integrate the work of each term, too
  SpatialOde(const SpatialSystem<R>& system, bool with_ledger);
  SpatialOde(const SpatialOde&) = delete;
  SpatialOde& operator=(const SpatialOde&) = delete;

  const SpatialSystem<R>& system() const { return system_; }          ///< whose equations these are
  bool with_ledger() const { return with_ledger_; }                   ///< is the work integrated?
  std::size_t mechanical_states() const { return system_.states(); }  ///< of (r, p; ṙ, ω′)
  std::size_t dimension() const { return mechanical_states() + (with_ledger_ ? works() : 0); }  ///< number of states
  /// Number of terms of a ledger.
  std::size_t works() const { return ledger_terms + (system_.elements().has_dampers() ? 1 : 0); }
  std::size_t evaluations() const { return evaluations_; }  ///< of ẏ, so far
  void count_from(std::size_t n) { evaluations_ = n; }      ///< looks at a run are none of its cost

  /// Of the joints; empty where none has any. May be changed.
  std::vector<JointMemory<R>>& memory() {
    is_evaluated_ = false;
    return memory_;
  }
  const std::vector<JointMemory<R>>& memory() const { return memory_; }  ///< likewise, to be looked at

  /// Of the tables of moving loads over angles, one a load; empty without any. Equations that are integrated read those
  /// that are held; looks at a state read what it says. Who changes them says forget().
  std::vector<TablePiece>& table_pieces() { return table_pieces_; }
  void forget() { is_evaluated_ = false; }  ///< the next evaluation is made anew
  /// Counts the revolutions of angles, as far as a run has come; empty of a system without counted angles.
  const TurnHistory<R>& turns() const { return turns_; }
  /// Forgets revolutions, and counts from a start on.
  void start_turns(const R& t, const State& y) {
    turns_.clear();
    count_turns(t, y);
  }
  /// Angles at the next state of a run, which is little more than an accepted step after the last one.
  void count_turns(const R& t, const State& y) {
    if (turns_.empty()) return;
    const auto& angles = system_.elements().angles;
    const auto frame = [&](std::size_t body) { return frame_in(y, body); };
    turns_.add(
        t,
        [&](std::size_t k, const R& near) {
          return angles[k].template motion<R>(frame(angles[k].first.body), frame(angles[k].second.body), near);
        },
        [&](std::size_t k) { return angles[k].zero; });
  }

  /// ẏ; counted.
  void rate(const State& y, State& dydt, const R& t) override;
  /// ∂ẏ/∂y, exact.
  void jacobian(const State& y, Jacobian& j, const R& t) override;
  /// ∂ẏ/∂t, exact.
  void time_slope(const State& y, State& slope, const R& t) override;

  /// e·ė of each joint whose film kinks where it closes and opens.
  void kinks(const State& y, const R&, std::vector<R>& values) override {
    values.clear();
    for (std::size_t j = 0; j < system_.joints().size(); ++j) {
      if (!system_.joints()[j].kinks()) continue;
      if (values.empty()) system_.place(y.data(), workspace());
      const JournalMotion<R> motion = system_.joint_kinematics(j, real_).motion;
      values.push_back(dot(motion.eccentricity, motion.velocity));
    }
  }

  /// Everything at a state: joints, multipliers, rows; with the memory given, or the current one.
  const SpatialWorkspace<R>& at(const R& t, const State& y, const std::vector<JointMemory<R>>& memory);
  const SpatialWorkspace<R>& at(const R& t, const State& y) { return at(t, y, memory_); }  ///< likewise
  /// Of the last evaluation. May be changed.
  SpatialWorkspace<R>& workspace() {
    is_evaluated_ = false;
    return real_;
  }
  const SpatialWorkspace<R>& last() const { return real_; }  ///< likewise, to be looked at
  const R& last_time() const { return evaluated_t_; }        ///< its time [s]

  /// ½ṙ·mṙ + ½ω′·J′ω′, and the potential energy −Σ m g·r, with that of springs.
  /// @throws SpringWithoutDirection, AngleNotCounted
  MechanicalEnergy<R> energy(const R& t, const State& y) const {
    MechanicalEnergy<R> total{R(0), R(0)};
    const std::size_t n = system_.bodies().size();
    for (std::size_t b = 0; b < n; ++b) {
      const SpatialBody<R>& body = system_.bodies()[b];
      const SpatialMotion<R> motion = spatial_motion_in(y.data(), n, b);
      total.kinetic += (body.mass * dot(motion.velocity, motion.velocity) +
                        dot(motion.body_spin, product(body.inertia, motion.body_spin))) /
                       2;
      total.potential -= body.mass * dot(system_.gravity(), motion.position);
    }
    if (!system_.elements().springs.empty()) {
      total.potential += system_.elements().template energy<R>(elements_at(t, y));
    }
    return total;
  }

  /// A counted angle at a state. @throws AngleNotCounted
  AngleMotion<R> angle(const R& t, const State& y, std::size_t k) const { return elements_at(t, y).angle(k); }

  /// Powers of the terms of a ledger, of an evaluated workspace.
  /// @param power  works() numbers
  template <class T, class Time>
  void fill_powers(const Time& t, const SpatialWorkspace<T>& w, T* power) const {
    for (std::size_t i = 0; i < works(); ++i) power[i] = T(0);
    const auto add = [&](LedgerTerm term, const T& value) { power[static_cast<std::size_t>(term)] += value; };
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) {
      const SpatialBody<R>& body = system_.bodies()[b];
      for (Eigen::Index k = 0; k < 3; ++k)
        add(LedgerTerm::loads, T(body.load(k) * w.frames[b].velocity(k) + body.moment(k) * w.frames[b].spin(k)));
    }
    const SpatialForceElements<R>& elements = system_.elements();
    const auto in = system_.elements_in(t, w);
    if (!elements.loads.empty()) add(LedgerTerm::loads, elements.template load_power<T>(t, in, w.table_pieces));
    if (elements.has_dampers()) add(LedgerTerm::dampers, elements.template damper_power<T>(in));
    for (const SpatialJointForce<T>& joint : w.joints) {
      add(LedgerTerm::film, joint.film_power());
      add(LedgerTerm::contact, joint.contact_power());
    }
    for (std::size_t row = 0; row < w.rows.size(); ++row) {
      const bool drives = drives_[row];
      add(drives ? LedgerTerm::drivers : LedgerTerm::constraints,
          T(-w.multipliers[row] * (system_.constraint_rate(row, w) - w.rows[row].time_rate)));
    }
  }

 private:
  SpatialFrame<R> frame_in(const State& y, std::size_t body) const {
    return SpatialFrame<R>(spatial_motion_in(y.data(), system_.bodies().size(), body));
  }

  /// Frames and counted angles of a state, kept by reference.
  auto elements_at(const R& t, const State& y) const {
    const auto frame = [this, &y](std::size_t body) { return frame_in(y, body); };
    return typename SpatialSystem<R>::template ElementView<R, decltype(frame)>{system_, &turns_, t, frame};
  }

  /// Everything at (t, y), unless that was the last that was asked for: a step's end is, by its method, by the run and
  /// by the recorder.
  /// @param holds  are tables read by the pieces that are held?
  void evaluate(const R& t, const State& y, const std::vector<JointMemory<R>>& memory, bool holds) {
    const std::vector<TablePiece>* pieces = holds && !table_pieces_.empty() ? &table_pieces_ : nullptr;
    const bool is_same_piece = &memory == &memory_ || memory.empty();
    if (is_evaluated_ && is_same_piece && pieces == real_.table_pieces && t == evaluated_t_ && y == evaluated_y_)
      return;
    is_evaluated_ = false;
    ++evaluations_;
    real_.table_pieces = pieces;
    system_.evaluate(t, y.data(), memory, real_);
    is_evaluated_ = is_same_piece;
    evaluated_t_ = t;
    evaluated_y_ = y;
  }

  /// ẏ of an evaluated workspace.
  template <class T, class Time>
  void fill(const Time& t, std::vector<T>& dydt, const SpatialWorkspace<T>& w) const {
    const std::size_t n = system_.bodies().size();
    for (std::size_t b = 0; b < n; ++b) {
      const SpatialFrame<T>& frame = w.frames[b];
      const EulerParameters<T> p_rate = euler_rate(frame.parameters, frame.body_spin);
      for (std::size_t k = 0; k < 3; ++k) dydt[7 * b + k] = frame.velocity(static_cast<Eigen::Index>(k));
      for (std::size_t k = 0; k < 4; ++k) dydt[7 * b + 3 + k] = p_rate(static_cast<Eigen::Index>(k));
    }
    std::copy(w.accelerations.begin(), w.accelerations.end(),
              dydt.begin() + static_cast<std::ptrdiff_t>(system_.places()));
    if (with_ledger_) fill_powers(t, w, &dydt[mechanical_states()]);
  }

  const SpatialSystem<R>& system_;
  bool with_ledger_;
  SpatialWorkspace<R> real_;
  SpatialWorkspace<Seeded> dual_;
  std::vector<Seeded> seeded_, powers_;
  RunTimeJacobian<jacobian_group, R> derivatives_;
  std::vector<JointMemory<R>> memory_;
  std::vector<TablePiece> table_pieces_;
  TurnHistory<R> turns_;
  std::vector<bool> drives_;  ///< of each row
  State evaluated_y_;
  R evaluated_t_{};
  bool is_evaluated_ = false;  ///< does real_ hold everything there, of the present memory?
  std::size_t evaluations_ = 0;
};

// Out of the class, where no function is inline: a declaration of an instance then spares those who include it the
// compilation of every law on numbers with derivatives.

template <class R>
SpatialOde<R>::SpatialOde(const SpatialSystem<R>& system, bool with_ledger)
    : system_(system),
      with_ledger_(with_ledger),
      real_(system.template workspace<R>()),
      dual_(system.template workspace<Seeded>()),
      turns_(system.elements().angles.size()) {
  const auto& loads = system.elements().loads;
  const bool reads_angles = std::any_of(loads.begin(), loads.end(), [](const auto& load) {
    const auto* table = std::get_if<SpatialTableLoad<R>>(&load);
    return table != nullptr && table->of_angle;
  });
  if (reads_angles) table_pieces_.resize(loads.size());
  if (!turns_.empty()) real_.turns = dual_.turns = dual_.implicit.at.turns = &turns_;
  if (reads_angles) dual_.table_pieces = dual_.implicit.at.table_pieces = &table_pieces_;
  for (std::size_t row = 0; row < system.constraint_rows(); ++row)
    drives_.push_back(system.constraints()[system.constraint_of(row)].is_driver());
  const auto& joints = system.joints();
  const bool remembers = std::any_of(joints.begin(), joints.end(), [](const SpatialJointElement<R>& joint) {
    return joint.plane.has_contact() || joint.plane.has_half_film();
  });
  if (remembers) memory_.resize(joints.size());
}

template <class R>
void SpatialOde<R>::rate(const State& y, State& dydt, const R& t) {
  evaluate(t, y, memory_, true);
  fill(t, dydt, real_);
}

template <class R>
void SpatialOde<R>::jacobian(const State& y, Jacobian& j, const R& t) {
  const auto size = static_cast<Eigen::Index>(y.size());
  j.setZero(size, size);
  system_.evaluate(t, y.data(), memory_, dual_.implicit.at);
  seeded_.assign(y.begin(), y.end());
  const std::size_t places = system_.places();
  for (std::size_t b = 0; b < system_.bodies().size(); ++b) {
    const auto column = [&](std::size_t k) {
      return k < spatial_coordinates ? spatial_coordinates * b + k
                                     : places + spatial_velocities * b + (k - spatial_coordinates);
    };
    for (std::size_t k = 0; k < spatial_states; ++k)
      seeded_[column(k)] = Seeded::variable(y[column(k)], static_cast<Eigen::Index>(k));
    system_.differentiate(b, t, seeded_.data(), memory_, dual_);
    const auto put = [&](std::size_t row, const Seeded& rate) {
      for (std::size_t k = 0; k < spatial_states; ++k) {
        j(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column(k))) =
            rate.derivatives()(static_cast<Eigen::Index>(k));
      }
    };
    const SpatialFrame<Seeded>& frame = dual_.frames[b];
    const EulerParameters<Seeded> p_rate = euler_rate(frame.parameters, frame.body_spin);
    for (std::size_t k = 0; k < 3; ++k) put(spatial_coordinates * b + k, frame.velocity(static_cast<Eigen::Index>(k)));
    for (std::size_t k = 0; k < 4; ++k) put(spatial_coordinates * b + 3 + k, p_rate(static_cast<Eigen::Index>(k)));
    for (std::size_t i = 0; i < dual_.accelerations.size(); ++i) put(places + i, dual_.accelerations[i]);
    if (with_ledger_) {
      powers_.resize(works());
      fill_powers(t, dual_, powers_.data());
      for (std::size_t i = 0; i < works(); ++i) put(mechanical_states() + i, powers_[i]);
    }
    for (std::size_t k = 0; k < spatial_states; ++k) seeded_[column(k)] = Seeded(y[column(k)]);
  }
}

template <class R>
void SpatialOde<R>::time_slope(const State& y, State& slope, const R& t) {
  const auto rate = [&](const auto& x, auto& dxdt, const Seeded& s) {
    system_.evaluate(s, x.data(), memory_, dual_);
    fill(s, dxdt, dual_);
  };
  derivatives_.fill_time_slope(rate, y, t, slope);
}

template <class R>
const SpatialWorkspace<R>& SpatialOde<R>::at(const R& t, const State& y, const std::vector<JointMemory<R>>& memory) {
  const std::size_t counted = evaluations_;
  evaluate(t, y, memory, false);
  evaluations_ = counted;
  return real_;
}

}  // namespace lubjoint
