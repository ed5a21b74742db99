/// Film forces of many states at once.
///
/// States and forces are arrays, one for each component. Every row gets the bits that the functions for one state give
/// (both compiled with -ffp-contract=off), whatever the instruction set, the number of rows and their place.
///
/// On x86-64 with AVX2 and FMA, which is found out at run time, every law that is a formula is evaluated four rows an
/// instruction, on AMD's processors with AVX-512 eight. Elsewhere it is evaluated one by one, and so are single rows that
/// need care (u = 0; ê = 0 under a half film; |u| or |ê| beyond 1e±59), published fits, and the laws that are tables,
/// whose sums are vector instructions in each row already; their bits are those of the functions for one state if both
/// are compiled for the same instruction set, which is what decides the order in which a sum is taken.
///
/// An array that is written may be one that is read. Nothing is allocated.
/// This header needs the compiled part lubjoint::batch.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "lubjoint/film/bearing.hpp"
#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/film/film_state.hpp"

namespace lubjoint {

/// Film states in an inertial frame: ê [-] and u [1/s], as in FilmState.
struct FilmStateArrays {
  std::span<const double> ex;  ///< ê, x
  std::span<const double> ey;  ///< ê, y
  std::span<const double> ux;  ///< u, x
  std::span<const double> uy;  ///< u, y
};

/// Film states in polar components: ε [-], a and b [1/s], as in PolarFilmState.
struct PolarStateArrays {
  std::span<const double> eccentricity_ratio;  ///< ε
  std::span<const double> slip_rate;           ///< a
  std::span<const double> squeeze_rate;        ///< b
};

/// Motions of journals in their bearings, as in JournalMotion: e [m], v [m/s], absolute spins [rad/s].
struct JournalMotionArrays {
  std::span<const double> ex;            ///< e, x
  std::span<const double> ey;            ///< e, y
  std::span<const double> vx;            ///< v, x
  std::span<const double> vy;            ///< v, y
  std::span<const double> bearing_spin;  ///< ω_B
  std::span<const double> journal_spin;  ///< ω_J
};

/// Where forces go: x and y for states and motions in a frame, radial and tangential for polar states.
struct ForceArrays {
  std::span<double> first;   ///< x, or radial
  std::span<double> second;  ///< y, or tangential
};

/// A row without a film: |e| ≥ c, or a number that is not finite. The rows before it are answered, the others are as
/// they were.
class FilmRowError : public FilmDomainError {
 public:
  /// @param reason  what is wrong with the row, and what is allowed
  FilmRowError(std::size_t row, const std::string& reason);
  std::size_t row() const { return row_; }               ///< counted from 0
  const std::string& reason() const { return reason_; }  ///< without the row

 private:
  std::size_t row_;
  std::string reason_;
};

/// A row whose force is beyond the range of double precision; rows as for FilmRowError.
class ForceRowError : public std::range_error {
 public:
  /// The message names the row.
  explicit ForceRowError(std::size_t row);
  std::size_t row() const { return row_; }  ///< counted from 0

 private:
  std::size_t row_;
};

/// How rows are evaluated; the bits are the same.
enum class InstructionSet {
  scalar,  ///< one row after the other, with what the build was compiled for
  avx2,    ///< AVX2 and FMA, x86-64
  avx512   ///< AVX-512 F, DQ and VL, x86-64, where GCC compiled the library
};

/// "scalar", "avx2" or "avx512".
std::string_view name_of(InstructionSet set);
/// True if this machine, and this build, have it.
bool is_available(InstructionSet set);
/// avx512 on AMD's processors that have it, else avx2 where it is available: Intel's gain nothing by wider vectors.
InstructionSet fastest_instruction_set();

/// Forces over the force scale, F/S [1/s].
/// @param law  any but those of finite length, whose ratio depends on the bearing's L/D; tables have a function below
/// @throws FilmRowError, ForceRowError; std::invalid_argument for an unknown law, arrays of different lengths, an array
///         that is written and overlaps another without being it, and an instruction set that is not available
void film_force_ratios(std::string_view law, const FilmStateArrays& states, const ForceArrays& ratios,
                       InstructionSet set = fastest_instruction_set());

/// Forces of the film on the journal [N] by any law that is a formula; errors as of film_force_ratios, and as of
/// require_shape for a bearing that a law of finite length is not made for.
void film_forces(std::string_view law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                 const FilmStateArrays& states, const ForceArrays& forces,
                 InstructionSet set = fastest_instruction_set());
/// The same of polar states: radial and tangential forces.
void film_forces(std::string_view law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                 const PolarStateArrays& states, const ForceArrays& forces,
                 InstructionSet set = fastest_instruction_set());
/// The same of motions: forces in their frame.
void film_forces(std::string_view law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                 const JournalMotionArrays& motions, const ForceArrays& forces,
                 InstructionSet set = fastest_instruction_set());

/// The same by a law with its table; its ratio needs no bearing, as the table is of one L/D. F/S as in its header, to
/// the error that the table states. FiniteFull, FiniteHalf, FiniteDynamic and FiniteReynolds convert to AnyCompiledLaw,
/// by a copy of their table: who calls for few rows at a time keeps the converted one.
/// @throws FilmRowError, ForceRowError and std::invalid_argument for arrays as above
void film_force_ratios(const AnyCompiledLaw& law, const FilmStateArrays& states, const ForceArrays& ratios);
/// @throws as above, and std::invalid_argument if the law was compiled for another L/D
void film_forces(const AnyCompiledLaw& law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                 const FilmStateArrays& states, const ForceArrays& forces);
/// The same of polar states: radial and tangential forces.
void film_forces(const AnyCompiledLaw& law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                 const PolarStateArrays& states, const ForceArrays& forces);
/// The same of motions: forces in their frame.
void film_forces(const AnyCompiledLaw& law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                 const JournalMotionArrays& motions, const ForceArrays& forces);

}  // namespace lubjoint
