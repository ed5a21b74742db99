/// Journals that slide on the jump of their half film: constraint rows whose forces are the films' own.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lubjoint/multibody/system_workspace.hpp"

namespace lubjoint::detail {

/// Calls act(body, row's columns, force's columns) for both sides of a slide that are bodies.
template <class System, class T, class Act>
void for_each_side(const System& system, const FilmSlide<T>& slide, const Act& act) {
  const auto& joint = system.joints()[slide.joint];
  if (joint.bearing_at.body != ground_body) act(joint.bearing_at.body, slide.row.first, slide.on_bearing);
  if (joint.journal_at.body != ground_body) act(joint.journal_at.body, slide.row.second, slide.on_journal);
}

/// Φq x of a slide's row. V: R or T.
template <class System, class T, class V>
T across_line(const System& system, const FilmSlide<T>& slide, const std::vector<V>& x) {
  T sum(0);
  for_each_side(system, slide, [&](std::size_t body, const auto& columns, const auto&) {
    for (std::size_t c = 0; c < 3; ++c) sum += columns[c] * x[3 * body + c];
  });
  return sum;
}

/// A tangential force into the joint's results; the bodies have theirs.
template <class System, class T>
void push_journal(const System& system, const FilmSlide<T>& slide, const T& force, SystemWorkspace<T>& w) {
  const Vector2<T>& n = slide.place.line;
  Vector2<T>& film = w.joints[slide.joint].film;
  film.x() -= force * n.y();
  film.y() += force * n.x();
  for (std::size_t k = 0; k < system.sheared_joints().size(); ++k) {
    if (system.sheared_joints()[k] == slide.joint) w.shear_torques[k] -= force * slide.place.along / 2;
  }
}

/// Rows n⊥·e = 0 of the journals that slide, from the frames, and what their forces act on. With
/// d(n⊥)/dt = −ω̄ n:  Φ̇ = n⊥·v − ω̄ n·e,  Φ̈ = n⊥·v̇ − ½(ω̇_i + ω̇_j) n·e − 2ω̄ n·v − ω̄² n⊥·e.
/// The force's virtual power is not that of a multiplier of this row: at the bearing's body it turns with ω_i, the
/// line with ω̄. The film's work on a spin is what lies between (3.4), unless its shear is modelled.
template <class System, class T>
void evaluate_slides(const System& system, const std::vector<JointMemory<RealOf<T>>>& memory, SystemWorkspace<T>& w) {
  for (FilmSlide<T>& slide : w.slides) {
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

/// Φ̇ of a journal's line.
template <class System, class T>
T slide_rate(const System& system, const FilmSlide<T>& slide, const SystemWorkspace<T>& w) {
  T rate(0);
  for_each_side(system, slide, [&](std::size_t body, const auto& columns, const auto&) {
    const PlanarFrame<T>& frame = w.frames[body];
    rate += columns[0] * frame.velocity.x() + columns[1] * frame.velocity.y() + columns[2] * frame.spin;
  });
  return rate;
}

/// The tangential forces that keep every journal that slides on its line, put into the workspace:
///   Φ̈ = 0,  q̈ = q̈₀ + Σ q̈_k T_k,  q̈_k what T_k = 1 does through mass and constraints.
/// The matrix has as many rows as journals slide, and is not symmetric.
template <class System, class T>
void hold_slides(const System& system, const std::vector<JointMemory<RealOf<T>>>& memory, SystemWorkspace<T>& w) {
  using R = RealOf<T>;
  evaluate_slides(system, memory, w);
  auto& response = w.slide_response;
  const auto count = static_cast<Eigen::Index>(w.slides.size());
  const auto n = static_cast<Eigen::Index>(system.coordinates());
  const auto rows = static_cast<Eigen::Index>(system.constraint_rows());
  response.accelerations.setZero(n, count);
  response.multipliers.setZero(rows, count);
  response.weights.resize(count);
  using std::abs;
  typename SlideResponse<R>::Matrix matrix(count, count);
  Eigen::Matrix<R, Eigen::Dynamic, 1> wanted(count);
  std::vector<R>& a = response.solution;
  std::vector<R>& lambda = response.lambda;
  a.resize(system.coordinates());
  lambda.resize(system.constraint_rows());
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = system.inverse_mass(i / 3)[i % 3] * value_of(w.forces[i]);
  for (std::size_t i = 0; i < lambda.size(); ++i) lambda[i] = -value_of(system.wanted_acceleration(i, w));
  system.constrain(w, lambda.data(), a.data());
  for (Eigen::Index k = 0; k < count; ++k) {
    const FilmSlide<T>& slide = w.slides[static_cast<std::size_t>(k)];
    wanted(k) = value_of(slide.row.gamma) - value_of(across_line(system, slide, a));
    response.weights(k) = abs(value_of(system.joints()[slide.joint].jump_force(slide.place).reach));
  }
  const R largest = response.weights.maxCoeff();
  // So that one without a reach of its own still has a part.
  response.weights.array() += largest > 0 ? R(largest / 1000) : R(1);
  for (Eigen::Index k = 0; k < count; ++k) {
    std::fill(a.begin(), a.end(), R(0));
    std::fill(lambda.begin(), lambda.end(), R(0));
    for_each_side(system, w.slides[static_cast<std::size_t>(k)], [&](std::size_t body, const auto&, const auto& push) {
      for (std::size_t c = 0; c < 3; ++c) a[3 * body + c] += system.inverse_mass(body)[c] * value_of(push[c]);
    });
    system.constrain(w, lambda.data(), a.data());
    for (Eigen::Index i = 0; i < n; ++i) response.accelerations(i, k) = a[static_cast<std::size_t>(i)];
    for (Eigen::Index i = 0; i < rows; ++i) response.multipliers(i, k) = lambda[static_cast<std::size_t>(i)];
    for (Eigen::Index i = 0; i < count; ++i) {
      matrix(i, k) = value_of(across_line(system, w.slides[static_cast<std::size_t>(i)], a));
    }
  }
  response.decomposition.setThreshold(1e4 * std::numeric_limits<R>::epsilon());  // rounding of the rows
  response.decomposition.compute(matrix * response.weights.asDiagonal());
  wanted = response.forces_for(wanted);
  for (Eigen::Index k = 0; k < count; ++k) {
    FilmSlide<T>& slide = w.slides[static_cast<std::size_t>(k)];
    slide.force = T(wanted(k));
    for_each_side(system, slide, [&](std::size_t body, const auto&, const auto& push) {
      for (std::size_t c = 0; c < 3; ++c) w.forces[3 * body + c] += push[c] * slide.force;
    });
    push_journal(system, slide, slide.force, w);
  }
}

/// After a solve with the tangential forces held at their values: Φ̈ = 0 gives their derivatives.
template <class System, class T>
void differentiate_slides(const System& system, SystemWorkspace<T>& w) {
  using R = RealOf<T>;
  using Derivatives = typename ImplicitDifferentiation<T>::Derivatives;
  const SlideResponse<R>& response = w.slide_response;
  const auto count = static_cast<Eigen::Index>(w.slides.size());
  Eigen::Matrix<R, Eigen::Dynamic, Derivatives::RowsAtCompileTime> change(count, Derivatives::RowsAtCompileTime);
  for (Eigen::Index k = 0; k < count; ++k) {
    const FilmSlide<T>& slide = w.slides[static_cast<std::size_t>(k)];
    change.row(k) = -T(across_line(system, slide, w.accelerations) - slide.row.gamma).derivatives().transpose();
  }
  change = response.forces_for(change);
  for (Eigen::Index k = 0; k < count; ++k) {
    FilmSlide<T>& slide = w.slides[static_cast<std::size_t>(k)];
    const Derivatives of_force = change.row(k).transpose();
    for (std::size_t i = 0; i < system.coordinates(); ++i) {
      w.accelerations[i].derivatives() += response.accelerations(static_cast<Eigen::Index>(i), k) * of_force;
    }
    for (std::size_t i = 0; i < system.constraint_rows(); ++i) {
      w.multipliers[i].derivatives() += response.multipliers(static_cast<Eigen::Index>(i), k) * of_force;
    }
    push_journal(system, slide, T(R(0), of_force), w);
    slide.force.derivatives() = of_force;
  }
}

}  // namespace lubjoint::detail
