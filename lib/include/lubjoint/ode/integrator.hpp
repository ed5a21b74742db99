/// What every integrator is to the runs: trial steps of a system of ordinary differential equations.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace lubjoint {

template <class State>
struct StepInterpolant;

/// In place of a number of states: it is known when the program runs.
inline constexpr std::size_t run_time_size = 0;

/// States of a system: as many as N says, or as many as there are.
template <class R, std::size_t N>
using StateOf = std::conditional_t<N == run_time_size, std::vector<R>, std::array<R, N>>;

/// Its Jacobian: of fixed size, or as large as there are states.
template <class R, std::size_t N>
using JacobianOf = Eigen::Matrix<R, N == run_time_size ? Eigen::Dynamic : static_cast<int>(N),
                                 N == run_time_size ? Eigen::Dynamic : static_cast<int>(N)>;

/// ẏ = f(y, t) and its exact derivatives. A rate outside its domain throws std::domain_error: the step is rejected.
template <class R, std::size_t N>
class OdeSystem {
 public:
  using State = StateOf<R, N>;        ///< y
  using Jacobian = JacobianOf<R, N>;  ///< ∂f/∂y

  virtual ~OdeSystem() = default;
  virtual void rate(const State& y, State& dydt, const R& t) = 0;         ///< f
  virtual void jacobian(const State& y, Jacobian& j, const R& t) = 0;     ///< ∂f/∂y
  virtual void time_slope(const State& y, State& slope, const R& t) = 0;  ///< ∂f/∂t
  /// Numbers whose changes of sign are kinks: f has one derivative there that is continuous, and no second one. Always
  /// as many.
  virtual void kinks(const State&, const R&, std::vector<R>& values) { values.clear(); }
  /// Of equations of motion y = (q, v, work), q̇ = v: of ∂v̇/∂(q, v) a part that forces make, which may be another at
  /// each stage of a step where films are thin, while the rest of ∂f/∂y changes as the bodies move. It costs a fraction
  /// of jacobian() at the state of which the last rate, or the last Jacobian, was asked.
  /// @param j  of the size of ∂f/∂y: its rows of v̇ are filled, and no other is to be read
  virtual void force_part(const State&, Jacobian& j, const R&) { j.setZero(); }
  /// Has it such a part?
  virtual bool has_force_part() const { return false; }
};

/// What a run of an integrator has cost beyond evaluations of f.
struct StepperCounts {
  std::size_t accepted = 0;           ///< steps
  std::size_t rejected = 0;           ///< trial steps that were given up
  std::size_t jacobians = 0;          ///< evaluations
  std::size_t factorisations = 0;     ///< of a real and a complex matrix each
  std::size_t newton_iterations = 0;  ///< of all steps
};

/// The error allowed in one step: of state i at most absolute[i] + relative |y_i|.
template <class R, std::size_t N>
struct StepTolerance {
  R relative;              ///< of the state
  StateOf<R, N> absolute;  ///< one for each state, in its own unit
  /// What an integrator that scales its own work by a tolerance (Radau's τ) takes for it.
  R nominal;
  /// How many of the last states are integrals that nothing depends on: they control no step, so that the others are
  /// the same without them.
  std::size_t integrals = 0;

  std::size_t controlled() const { return absolute.size() - integrals; }  ///< number of the states that do
};

/// One integrator with its memory of the steps so far.
template <class R, std::size_t N>
class Integrator {
 public:
  using System = OdeSystem<R, N>;  ///< what it integrates
  using State = StateOf<R, N>;     ///< of the system

  virtual ~Integrator() = default;

  /// One trial step. On success y and t are advanced and dt is the next step's length; on failure y and t are as they
  /// were and dt is shorter. A state with NaN or beyond a wall may count as a success: the caller looks at it.
  virtual bool try_step(System& system, State& y, R& t, R& dt) = 0;

  /// Forgets the steps so far: the state was changed by hand, or its rate has jumped.
  virtual void reset() = 0;

  /// The state was replaced by one close to it (projection): memory of the steps is kept if it can be.
  virtual void replace_state(const State&) { reset(); }

  /// Another one with the same tolerances and no memory.
  virtual std::unique_ptr<Integrator> fresh() const = 0;

  /// Replaces f at the end of the last step by the method's own derivative there, if it has a better one: in a stiff
  /// system f is what the step left of its error times the largest eigenvalue, and useless between the steps.
  /// @returns has it?
  virtual bool end_rate(State&) const { return false; }

  /// Gives the last step the motion inside it as the method sees it, if it sees more than the states at its ends and
  /// their rates, which are there. Later steps are the same with it and without.
  virtual void see_inside(System&, StepInterpolant<State>&) {}

  /// Are its steps of order 9? Then a step is as long as the motion inside it is seen by more than its ends, and what
  /// it integrates has to be as smooth.
  virtual bool is_of_order_nine() const { return false; }

  /// Is the rate at the ends of a step good enough to interpolate accelerations by?
  virtual bool has_smooth_rates() const { return true; }

  /// Into how many pieces a step is worth dividing when something is looked for inside it.
  virtual std::size_t looks_inside() const = 0;

  /// What its steps have cost so far.
  virtual StepperCounts counts() const { return {}; }
};

}  // namespace lubjoint
