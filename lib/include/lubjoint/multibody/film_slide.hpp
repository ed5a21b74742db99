/// Journals that slide on the jump of their half film: constraint rows whose forces are the films' own. A system of the
/// plane or of space says what they are (place_slides), and has here what follows from it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lubjoint/multibody/system_workspace.hpp"

namespace lubjoint::detail {

/// Calls act(body, row's columns, force's columns) for both sides of a slide that are bodies.
template <class System, class Slide, class Act>
void for_each_side(const System& system, const Slide& slide, const Act& act) {
  const auto& joint = system.joints()[slide.joint];
  if (joint.bearing_at.body != ground_body) act(joint.bearing_at.body, slide.row.first, slide.on_bearing);
  if (joint.journal_at.body != ground_body) act(joint.journal_at.body, slide.row.second, slide.on_journal);
}

/// Product of a slide's row with x(k), that of velocity k: with velocities Φ̇, with accelerations Φ̈ + γ.
template <class System, class Slide, class At>
auto across_line(const System& system, const Slide& slide, const At& x) {
  typename Slide::T sum(0);
  for_each_side(system, slide, [&](std::size_t body, const auto& columns, const auto&) {
    for (std::size_t c = 0; c < columns.size(); ++c) sum += columns[c] * x(columns.size() * body + c);
  });
  return sum;
}

/// Adds what a slide's tangential force does to the forces on the bodies and to the joint's results.
template <class System, class Slide, class Workspace>
void apply_slide(const System& system, const Slide& slide, Workspace& w) {
  for_each_side(system, slide, [&](std::size_t body, const auto&, const auto& columns) {
    for (std::size_t c = 0; c < columns.size(); ++c) w.forces[columns.size() * body + c] += columns[c] * slide.force;
  });
  system.push_journal(slide, slide.force, w);
}

/// Rows n⊥·e = 0 of the plane's journals that slide, from the frames, and what their forces act on. With
/// d(n⊥)/dt = −ω̄ n:  Φ̇ = n⊥·v − ω̄ n·e,  Φ̈ = n⊥·v̇ − ½(ω̇_i + ω̇_j) n·e − 2ω̄ n·v − ω̄² n⊥·e.
/// The force's virtual power is not that of a multiplier of this row: at the bearing's body it turns with ω_i, the
/// line with ω̄. The film's work on a spin is what lies between (3.4), unless its shear is modelled.
template <class System, class T>
void evaluate_slides(const System& system, const std::vector<JointMemory<RealOf<T>>>& memory, SystemWorkspace<T>& w) {
  for (auto& slide : w.slides) {
    const auto& joint = system.joints()[slide.joint];
    const PlanarFrame<T>& body_i = system.frame(joint.bearing_at.body, w);
    const PlanarFrame<T>& body_j = system.frame(joint.journal_at.body, w);
    const JointKinematics<T> k = joint.kinematics(body_i, body_j);
    slide.place = joint.slide_place(body_i, body_j, k.motion, memory[slide.joint]);
    const SlidePlace<T>& at = slide.place;
    const Vector2<T> across = perpendicular(at.line);
    const T mean_spin = (body_i.spin + body_j.spin) / 2;
    const T lever_i = dot(at.line, k.bearing_arm);  // n⊥·s_i⊥
    const T lever_j = dot(at.line, k.journal_arm);
    slide.row.value = at.across;
    slide.row.time_rate = T(0);
    slide.row.gamma = body_j.spin * body_j.spin * dot(across, k.journal_arm) -
                      body_i.spin * body_i.spin * dot(across, k.bearing_arm) +
                      2 * mean_spin * dot(at.line, k.motion.velocity) + mean_spin * mean_spin * at.across;
    slide.row.first = {T(-across.x()), T(-across.y()), T(-lever_i - at.along / 2)};
    slide.row.second = {across.x(), across.y(), T(lever_j - at.along / 2)};
    // With shear the film's tangential force turns both bodies: ½ e × F is taken from either (T_J and T_B).
    const T sheared = joint.shear ? T(at.along / 2) : T(0);
    slide.on_bearing = {T(-across.x()), T(-across.y()), T(-lever_i - at.along + sheared)};
    slide.on_journal = {across.x(), across.y(), T(lever_j - sheared)};
  }
}

/// The tangential forces that keep every journal that slides on its line, put into the workspace:
///   Φ̈ = 0,  v̇ = v̇₀ + Σ v̇_k T_k,  v̇_k what T_k = 1 does through mass and constraints.
/// The matrix has as many rows as journals slide, and is not symmetric. Needs rows and factors of the constraints, and
/// all other forces.
template <class System, class Workspace>
void hold_slides(const System& system, Workspace& w) {
  using R = typename Workspace::R;
  using T = typename decltype(w.slides)::value_type::T;
  using std::abs;
  auto& response = w.slide_response;
  const auto count = static_cast<Eigen::Index>(w.slides.size());
  const auto n = static_cast<Eigen::Index>(system.velocities());
  const auto rows = static_cast<Eigen::Index>(system.constraint_rows());
  response.accelerations.setZero(n, count);
  response.multipliers.setZero(rows, count);
  response.weights.resize(count);
  typename SlideResponse<R>::Matrix matrix(count, count);
  Eigen::Matrix<R, Eigen::Dynamic, 1> wanted(count);
  std::vector<R>& f = response.forces;
  std::vector<R>& a = response.solution;
  std::vector<R>& lambda = response.lambda;
  f.resize(system.velocities());
  a.resize(system.velocities());
  lambda.resize(system.constraint_rows());
  const auto accelerate = [&] {
    const std::size_t each = f.size() / system.bodies().size();
    for (std::size_t b = 0; b < system.bodies().size(); ++b) system.accelerate(b, &f[each * b], &a[each * b]);
    system.constrain(w, lambda.data(), a.data());
  };
  const auto across = [&](std::size_t k) {
    return value_of(across_line(system, w.slides[k], [&a](std::size_t i) -> const R& { return a[i]; }));
  };
  for (std::size_t i = 0; i < f.size(); ++i) f[i] = value_of(w.forces[i]);
  for (std::size_t i = 0; i < lambda.size(); ++i) lambda[i] = -value_of(system.wanted_acceleration(i, w));
  accelerate();
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto& slide = w.slides[static_cast<std::size_t>(k)];
    wanted(k) = value_of(slide.row.gamma) - across(static_cast<std::size_t>(k));
    response.weights(k) = abs(value_of(system.joint_in_plane(slide.joint).jump_force(slide.place).reach));
  }
  const R largest = response.weights.maxCoeff();
  // So that one without a reach of its own still has a part.
  response.weights.array() += largest > 0 ? R(largest / 1000) : R(1);
  for (Eigen::Index k = 0; k < count; ++k) {
    std::fill(f.begin(), f.end(), R(0));
    std::fill(lambda.begin(), lambda.end(), R(0));
    for_each_side(system, w.slides[static_cast<std::size_t>(k)], [&](std::size_t body, const auto&, const auto& by) {
      for (std::size_t c = 0; c < by.size(); ++c) f[by.size() * body + c] += value_of(by[c]);
    });
    accelerate();
    for (Eigen::Index i = 0; i < n; ++i) response.accelerations(i, k) = a[static_cast<std::size_t>(i)];
    for (Eigen::Index i = 0; i < rows; ++i) response.multipliers(i, k) = lambda[static_cast<std::size_t>(i)];
    for (Eigen::Index i = 0; i < count; ++i) matrix(i, k) = across(static_cast<std::size_t>(i));
  }
  response.decomposition.setThreshold(1e4 * std::numeric_limits<R>::epsilon());  // rounding of the rows
  response.decomposition.compute(matrix * response.weights.asDiagonal());
  wanted = response.forces_for(wanted);
  for (Eigen::Index k = 0; k < count; ++k) {
    auto& slide = w.slides[static_cast<std::size_t>(k)];
    slide.force = T(wanted(k));
    apply_slide(system, slide, w);
  }
}

/// After a solve with the tangential forces held at their values: Φ̈ = 0 gives their derivatives.
/// @param response  of the values
template <class System, class R, class Workspace>
void differentiate_slides(const System& system, const SlideResponse<R>& response, Workspace& w) {
  using T = typename decltype(w.slides)::value_type::T;
  using Derivatives = std::decay_t<decltype(std::declval<T>().derivatives())>;
  const auto count = static_cast<Eigen::Index>(w.slides.size());
  Eigen::Matrix<R, Eigen::Dynamic, Derivatives::RowsAtCompileTime> change(count, Derivatives::RowsAtCompileTime);
  const auto acceleration = [&w](std::size_t i) -> const T& { return w.accelerations[i]; };
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto& slide = w.slides[static_cast<std::size_t>(k)];
    change.row(k) = -T(across_line(system, slide, acceleration) - slide.row.gamma).derivatives().transpose();
  }
  change = response.forces_for(change);
  for (Eigen::Index k = 0; k < count; ++k) {
    auto& slide = w.slides[static_cast<std::size_t>(k)];
    const Derivatives of_force = change.row(k).transpose();
    for (std::size_t i = 0; i < system.velocities(); ++i) {
      w.accelerations[i].derivatives() += response.accelerations(static_cast<Eigen::Index>(i), k) * of_force;
    }
    for (std::size_t i = 0; i < system.constraint_rows(); ++i) {
      w.multipliers[i].derivatives() += response.multipliers(static_cast<Eigen::Index>(i), k) * of_force;
    }
    system.push_journal(slide, T(R(0), of_force), w);
    slide.force.derivatives() = of_force;
  }
}

}  // namespace lubjoint::detail
