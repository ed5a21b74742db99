/// Answers of programs that exist only in a test: right ones from the library, wrong ones from the gallery.
#pragma once

#include <fmt/format.h>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/joint/touching_journal.hpp"
#include "lubjoint/joint/wrench.hpp"
#include "oracle/verify/report.hpp"
#include "support/golden.hpp"

namespace lubjoint::test {

/// What the program asks about, with the golden data of this source.
inline std::vector<verify::State> states_to_verify(verify::Quantities quantities, std::size_t random,
                                                   std::uint64_t seed) {
  return verify::states_to_verify(quantities, golden_folder(), random, seed);
}

/// The library's answer to a state, computed in T throughout. @throws FilmDomainError
template <class T>
std::array<T, verify::most_answers> library_answer(verify::Quantities quantities, std::string_view law,
                                                   const verify::State& s) {
  const auto t = [](double x) { return static_cast<T>(x); };
  const Bearing<T> bearing{t(s.length), t(s.radius), t(s.clearance)};
  const Lubricant<T> oil{t(s.viscosity)};
  return with_film_law(law, [&]<class Law>() -> std::array<T, verify::most_answers> {
    if (quantities == verify::Quantities::polar) {
      const T ratio = t(s.eccentricity_ratio);
      const T a = ratio * (t(s.omega) - 2 * t(s.attitude_rate));
      const PolarForce<T> f = film_force<Law>(bearing, oil, PolarFilmState<T>(ratio, a, t(s.squeeze_rate)));
      return {f.radial, f.tangential, T(0), T(0)};
    }
    const JournalMotion<T> motion{{t(s.ex), t(s.ey)}, {t(s.vx), t(s.vy)}, t(s.omega_bearing), t(s.omega_journal)};
    Vector2<T> f;
    if (quantities == verify::Quantities::transition) {
      f = touching_journal_force<Law>(bearing, oil, TransitionTolerances<T>(t(s.e0), t(s.e1)),
                                      ContactSurface<T>{t(s.contact_stiffness), t(s.restitution)}, motion,
                                      t(s.impact_speed));
    } else {
      f = film_force<Law>(bearing, oil, film_state(motion, bearing.clearance()));
    }
    const JointKinematics<T> joint{{t(s.sx_i), t(s.sy_i)}, {t(s.sx_j), t(s.sy_j)}, motion};
    const JointWrenches<T> wrenches = joint_wrenches(joint, f);
    return {f.x(), f.y(), wrenches.bearing.moment, wrenches.journal.moment};
  });
}

/// Not numbers where the answerer throws FilmDomainError: ε rounds to 1 in single precision.
template <class Answerer>
verify::Answers answers_of(verify::Quantities quantities, const std::vector<verify::State>& states,
                           const Answerer& answerer) {
  std::vector<verify::Answer> values;
  for (const verify::State& state : states) {
    verify::Answer answer{};
    try {
      const auto given = answerer(state);
      for (std::size_t k = 0; k < answer.size(); ++k) answer[k] = static_cast<double>(given[k]);
    } catch (const FilmDomainError&) {
      answer.fill(std::numeric_limits<double>::quiet_NaN());
    }
    values.push_back(answer);
  }
  return verify::answers_from_numbers(quantities, std::move(values));
}

/// Answers of a program that is right but for these mistakes.
inline verify::Answers mistaken_answers(verify::Quantities quantities, verify::Law law,
                                        const std::vector<verify::State>& states,
                                        const std::vector<const verify::Mistake*>& mistakes) {
  return answers_of(quantities, states, [&](const verify::State& state) {
    return verify::solve_with(quantities, law, state, mistakes).answer;
  });
}

/// The same numbers printed and read back.
/// @param format  of one number, for fmt
inline verify::Answers through_text(verify::Quantities quantities, const verify::Answers& answers,
                                    const std::string& format) {
  std::string csv = "id";
  for (const auto name : verify::answer_columns(quantities)) csv.append(1, ',').append(name);
  csv += '\n';
  for (std::size_t i = 0; i < answers.values.size(); ++i) {
    csv += std::to_string(i + 1);
    for (std::size_t k = 0; k < verify::answer_columns(quantities).size(); ++k) {
      csv.append(1, ',').append(fmt::format(fmt::runtime(format), answers.values[i][k]));
    }
    csv += '\n';
  }
  return verify::read_answers(quantities, csv, "test", answers.values.size());
}

inline verify::Verification verified(verify::Quantities quantities, std::string_view law,
                                     const std::vector<verify::State>& states, const verify::Answers& answers) {
  return verify::verify_answers(quantities, std::string(law), states, answers);
}

constexpr std::array<verify::Quantities, 5> all_quantities = {
    verify::Quantities::dimensionless, verify::Quantities::cartesian, verify::Quantities::polar,
    verify::Quantities::wrench, verify::Quantities::transition};

}  // namespace lubjoint::test
