/// Error against run time of the force laws: one state at a time, in batches, in long double, and by solving for the
/// pressure.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lubjoint::reports {

/// One way to evaluate one law.
struct LawTiming {
  std::string law;
  std::string method;   ///< scalar, batch, long_double, quadrature, finite_length
  std::size_t states;   ///< golden states that the errors are of
  double median_error;  ///< over |F|, against the certified values
  double largest_error;
  double nanoseconds;  ///< median of one force
};

/// Batch evaluation by the number of rows, pinkus_sternlicht; medians of one force [ns].
struct BatchTiming {
  std::size_t rows;
  double states;   ///< ê and u given
  double polar;    ///< ε, a and b given
  double motions;  ///< e, v and spins given
};

struct LawBench {
  double bound;  ///< two square roots and a division at the batch's vector width [ns]
  std::vector<LawTiming> laws;
  std::vector<BatchTiming> batches;
};

/// Times are medians over repeats (at least 9) in which all methods of a law take turns, of random states with ε up to
/// 0.97. Quadrature leaves out rates beyond 1e±100. finite_length is the film of the same extent in the bearing of the
/// paper, L/D 2.04, with a tolerance of 1e-3: what it differs by is the model error of the law, not an error of its
/// own.
/// @param golden  data/golden/film_force.csv
/// @param quick   fewer repeats, and fewer golden states for the slow methods
LawBench time_laws(const std::filesystem::path& golden, bool quick);

std::string law_bench_csv(const LawBench& bench);
std::string batch_csv(const LawBench& bench);
std::string law_bench_table(const LawBench& bench);

}  // namespace lubjoint::reports
