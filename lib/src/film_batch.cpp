#include <algorithm>
#include <functional>
#include <initializer_list>

#include "film_rows.hpp"
#include "lubjoint/film/batch.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#define LUBJOINT_HAS_AVX2 1
#ifndef __clang__  // which has no such attribute for the width of its vectors
#define LUBJOINT_HAS_AVX512 1
#endif
#endif

namespace lubjoint {

FilmRowError::FilmRowError(std::size_t row, const std::string& reason)
    : FilmDomainError("row " + std::to_string(row) + ": " + reason), row_(row), reason_(reason) {}

ForceRowError::ForceRowError(std::size_t row)
    : std::range_error("row " + std::to_string(row) +
                       ": the force is beyond the range of double precision; allowed are smaller rates"),
      row_(row) {}

std::string_view name_of(InstructionSet set) {
  if (set == InstructionSet::avx512) return "avx512";
  return set == InstructionSet::avx2 ? "avx2" : "scalar";
}

bool is_available(InstructionSet set) {
#ifdef LUBJOINT_HAS_AVX512
  static const bool has_avx512 = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                                 __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("fma") != 0;
  if (set == InstructionSet::avx512) return has_avx512;
#endif
#ifdef LUBJOINT_HAS_AVX2
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  if (set == InstructionSet::avx2) return has_avx2;
#endif
  return set == InstructionSet::scalar;
}

InstructionSet fastest_instruction_set() {
#ifdef LUBJOINT_HAS_AVX512
  // AMD's cores take a wide operation in two halves, and as one where they look ahead past roots and quotients: twice
  // as many rows are under way. On Intel's nothing was gained.
  static const bool gains = __builtin_cpu_is("amd") != 0;
  if (gains && is_available(InstructionSet::avx512)) return InstructionSet::avx512;
#endif
  return is_available(InstructionSet::avx2) ? InstructionSet::avx2 : InstructionSet::scalar;
}

namespace {

using detail::ForceBlock;

#ifdef LUBJOINT_HAS_AVX2
template <FilmLaw Law, class Rows>
[[gnu::target("avx2,fma"), gnu::flatten]] std::size_t evaluate_avx2(const Rows& rows, std::size_t begin,
                                                                    std::size_t end, double scale, double* first,
                                                                    double* second, ForceBlock& block) {
  return detail::evaluate_blocks<Law>(rows, begin, end, scale, first, second, block);
}
#endif
#ifdef LUBJOINT_HAS_AVX512
template <FilmLaw Law, class Rows>
[[gnu::target("avx512f,avx512dq,avx512vl,fma,prefer-vector-width=512"), gnu::flatten]] std::size_t evaluate_avx512(
    const Rows& rows, std::size_t begin, std::size_t end, double scale, double* first, double* second,
    ForceBlock& block) {
  return detail::evaluate_blocks<Law>(rows, begin, end, scale, first, second, block);
}
#endif

/// Whole blocks from row begin on. @returns the row before which all are answered; the block takes the next rows'
/// forces
template <FilmLaw Law, class Rows>
std::size_t evaluated_together([[maybe_unused]] const Rows& rows, std::size_t begin, [[maybe_unused]] std::size_t end,
                               [[maybe_unused]] double scale, [[maybe_unused]] double* first,
                               [[maybe_unused]] double* second, [[maybe_unused]] ForceBlock& block,
                               [[maybe_unused]] InstructionSet set) {
#ifdef LUBJOINT_HAS_AVX512
  if (set == InstructionSet::avx512) return evaluate_avx512<Law>(rows, begin, end, scale, first, second, block);
#endif
#ifdef LUBJOINT_HAS_AVX2
  if (set == InstructionSet::avx2) return evaluate_avx2<Law>(rows, begin, end, scale, first, second, block);
#endif
  return begin;
}

template <FilmLaw Law>
Vector2<double> ratio_of(const FilmState<double>& film) {
  return force_ratio<Law>(film);
}

template <FilmLaw Law>
Vector2<double> ratio_of(const PolarFilmState<double>& state) {
  const PolarForce<double> ratio = polar_force_ratio<Law>(state);
  return Vector2<double>(ratio.radial, ratio.tangential);
}

/// Rows begin…end − 1, one after the other.
template <FilmLaw Law, class Rows>
void evaluate_checked(const Rows& rows, std::size_t begin, std::size_t end, double scale, const ForceArrays& forces) {
  for (std::size_t i = begin; i < end; ++i) {
    try {
      const Vector2<double> force = scale * ratio_of<Law>(rows.checked(i));
      if (!std::isfinite(force.x()) || !std::isfinite(force.y())) throw ForceRowError(i);
      forces.first[i] = force.x();
      forces.second[i] = force.y();
    } catch (const FilmDomainError& error) {
      throw FilmRowError(i, error.what());
    }
  }
}

/// Rows begin…end − 1 of a block of which one is not ordinary: the others' forces are known.
template <FilmLaw Law, class Rows>
void finish_block(const Rows& rows, std::size_t begin, std::size_t end, double scale, const ForceArrays& forces,
                  const ForceBlock& block) {
  for (std::size_t i = begin; i < end; ++i) {
    if (!detail::is_ordinary<Law>(rows.quick(i))) {
      evaluate_checked<Law>(rows, i, i + 1, scale, forces);
      continue;
    }
    forces.first[i] = block.first.values[i - begin];
    forces.second[i] = block.second.values[i - begin];
  }
}

template <FilmLaw Law, class Rows>
void evaluate(const Rows& rows, double scale, const ForceArrays& forces, InstructionSet set) {
  const std::size_t n = forces.first.size(), whole = n - n % detail::block_rows;
  const bool together = set != InstructionSet::scalar && detail::is_ordinary_scale(scale);
  if (!together) return evaluate_checked<Law>(rows, 0, n, scale, forces);
  ForceBlock block{};
  std::size_t begin = 0;
  while (begin < whole) {
    begin = evaluated_together<Law>(rows, begin, whole, scale, forces.first.data(), forces.second.data(), block, set);
    if (begin == whole) break;
    finish_block<Law>(rows, begin, begin + detail::block_rows, scale, forces, block);
    begin += detail::block_rows;
  }
  if (begin == n) return;
  detail::BlockColumn room[detail::most_columns];
  const Rows rest = rows.padded(begin, n - begin, room);
  evaluated_together<Law>(rest, 0, detail::block_rows, scale, block.first.values, block.second.values, block, set);
  finish_block<Law>(rows, begin, n, scale, forces, block);
}

/// One state after the other, of a law that needs more than the state.
template <class Rows, class Force>
void evaluate_singly(const Rows& rows, const ForceArrays& forces, const Force& force_of) {
  for (std::size_t i = 0; i < forces.first.size(); ++i) {
    try {
      const Vector2<double> force = force_of(rows.checked(i));
      if (!std::isfinite(force.x()) || !std::isfinite(force.y())) throw ForceRowError(i);
      forces.first[i] = force.x();
      forces.second[i] = force.y();
    } catch (const FilmDomainError& error) {
      throw FilmRowError(i, error.what());
    }
  }
}

struct NamedInput {
  const char* name;
  std::span<const double> values;
};

bool overlap(std::span<const double> a, std::span<const double> b) {
  const std::less<const double*> before;
  return !a.empty() && !b.empty() && before(a.data(), b.data() + b.size()) && before(b.data(), a.data() + a.size());
}

void require_arrays(std::initializer_list<NamedInput> inputs, const ForceArrays& forces, InstructionSet set) {
  if (!is_available(set)) {
    throw std::invalid_argument("instruction set " + std::string(name_of(set)) +
                                " is not available on this machine; allowed is scalar");
  }
  const std::size_t rows = forces.first.size();
  const auto require_rows = [rows](const char* name, std::size_t size) {
    if (size == rows) return;
    throw std::invalid_argument(std::string(name) + " has " + std::to_string(size) +
                                " rows; allowed are as many as the first array of forces has, " + std::to_string(rows));
  };
  require_rows("the second array of forces", forces.second.size());
  if (overlap(forces.first, forces.second)) {
    throw std::invalid_argument("the two arrays of forces overlap; allowed are separate ones");
  }
  for (const NamedInput& input : inputs) {
    require_rows(input.name, input.values.size());
    for (const std::span<double> output : {forces.first, forces.second}) {
      if (input.values.data() == output.data() || !overlap(input.values, output)) continue;
      throw std::invalid_argument(std::string("an array of forces overlaps ") + input.name +
                                  "; allowed are the same array and separate ones");
    }
  }
}

detail::PlaneRows plane_rows(const FilmStateArrays& s, const ForceArrays& forces, InstructionSet set) {
  require_arrays({{"ex", s.ex}, {"ey", s.ey}, {"ux", s.ux}, {"uy", s.uy}}, forces, set);
  return {s.ex.data(), s.ey.data(), s.ux.data(), s.uy.data()};
}

detail::PolarRows polar_rows(const PolarStateArrays& s, const ForceArrays& forces, InstructionSet set) {
  require_arrays(
      {{"eccentricity_ratio", s.eccentricity_ratio}, {"slip_rate", s.slip_rate}, {"squeeze_rate", s.squeeze_rate}},
      forces, set);
  return {s.eccentricity_ratio.data(), s.slip_rate.data(), s.squeeze_rate.data()};
}

detail::MotionRows motion_rows(const JournalMotionArrays& m, double clearance, const ForceArrays& forces,
                               InstructionSet set) {
  require_arrays({{"ex", m.ex},
                  {"ey", m.ey},
                  {"vx", m.vx},
                  {"vy", m.vy},
                  {"bearing_spin", m.bearing_spin},
                  {"journal_spin", m.journal_spin}},
                 forces, set);
  return {m.ex.data(), m.ey.data(), m.vx.data(), m.vy.data(), m.bearing_spin.data(), m.journal_spin.data(), clearance};
}

Vector2<double> as_pair(const Vector2<double>& force) { return force; }
Vector2<double> as_pair(const PolarForce<double>& force) { return {force.radial, force.tangential}; }

void require_formula(std::string_view law) {
  if (!is_compiled_law(law)) return;
  throw std::invalid_argument("the law " + std::string(law) +
                              " is a table, and its name alone has none; allowed is the law with its table, as "
                              "read_compiled_film and with_compiled_law make it");
}

template <class Rows>
void evaluate_in_bearing(std::string_view law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                         const Rows& rows, const ForceArrays& forces, InstructionSet set) {
  require_formula(law);
  with_film_law<EveryFilmLaw>(law, [&]<class Law>() {
    if constexpr (ShapedFilmLaw<Law>) {
      require_shape<Law>(length_to_diameter(bearing));
      evaluate_singly(rows, forces, [&](const auto& state) { return as_pair(film_force<Law>(bearing, oil, state)); });
    } else {
      evaluate<Law>(rows, force_scale(Law::limit, bearing, oil), forces, set);
    }
  });
}

template <class Law>
Vector2<double> ratio_of(const Law& law, const FilmState<double>& film) {
  return compiled_force_ratio(law, film);
}

template <class Law>
Vector2<double> ratio_of(const Law& law, const PolarFilmState<double>& state) {
  return as_pair(compiled_polar_force_ratio(law, state));
}

template <class Rows>
void evaluate_in_bearing(const AnyCompiledLaw& law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                         const Rows& rows, const ForceArrays& forces) {
  std::visit(
      [&]<class Law>(const Law& compiled) {
        require_shape_of(compiled, bearing);
        const double scale = force_scale(Law::limit, bearing, oil);
        evaluate_singly(rows, forces,
                        [&](const auto& state) -> Vector2<double> { return scale * ratio_of(compiled, state); });
      },
      law);
}

}  // namespace

void film_force_ratios(std::string_view law, const FilmStateArrays& states, const ForceArrays& ratios,
                       InstructionSet set) {
  const detail::PlaneRows rows = plane_rows(states, ratios, set);
  require_formula(law);
  with_film_law<EveryFilmLaw>(law, [&]<class Law>() {
    if constexpr (ShapedFilmLaw<Law>) {
      throw std::invalid_argument("the force ratio of " + std::string(law) +
                                  " depends on the bearing; allowed is its force in a bearing");
    } else {
      evaluate<Law>(rows, 1.0, ratios, set);
    }
  });
}

void film_forces(std::string_view law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                 const FilmStateArrays& states, const ForceArrays& forces, InstructionSet set) {
  evaluate_in_bearing(law, bearing, oil, plane_rows(states, forces, set), forces, set);
}

void film_forces(std::string_view law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                 const PolarStateArrays& states, const ForceArrays& forces, InstructionSet set) {
  evaluate_in_bearing(law, bearing, oil, polar_rows(states, forces, set), forces, set);
}

void film_forces(std::string_view law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                 const JournalMotionArrays& motions, const ForceArrays& forces, InstructionSet set) {
  evaluate_in_bearing(law, bearing, oil, motion_rows(motions, bearing.clearance(), forces, set), forces, set);
}

void film_force_ratios(const AnyCompiledLaw& law, const FilmStateArrays& states, const ForceArrays& ratios) {
  const detail::PlaneRows rows = plane_rows(states, ratios, InstructionSet::scalar);
  std::visit(
      [&](const auto& compiled) {
        evaluate_singly(rows, ratios, [&](const FilmState<double>& film) { return ratio_of(compiled, film); });
      },
      law);
}

void film_forces(const AnyCompiledLaw& law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                 const FilmStateArrays& states, const ForceArrays& forces) {
  evaluate_in_bearing(law, bearing, oil, plane_rows(states, forces, InstructionSet::scalar), forces);
}

void film_forces(const AnyCompiledLaw& law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                 const PolarStateArrays& states, const ForceArrays& forces) {
  evaluate_in_bearing(law, bearing, oil, polar_rows(states, forces, InstructionSet::scalar), forces);
}

void film_forces(const AnyCompiledLaw& law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                 const JournalMotionArrays& motions, const ForceArrays& forces) {
  evaluate_in_bearing(law, bearing, oil, motion_rows(motions, bearing.clearance(), forces, InstructionSet::scalar),
                      forces);
}

}  // namespace lubjoint
