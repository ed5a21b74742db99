/// Error and run time of the laws that are tables, beside those of Pinkus and Sternlicht's.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lubjoint/film/compiled_law.hpp"
#include "lubjoint/scene/scene.hpp"

namespace lubjoint::reports {

/// One way to use one law.
struct CompiledLawTiming {
  std::string law;
  std::string method;  ///< scalar, jacobian, batch; simulate: a run of a scene
  std::size_t states;  ///< golden states that the errors are of; none for a derivative, a run or a law that is no table
  double median_error;  ///< over |F|, against the certified and the solved forces
  double largest_error;
  double nanoseconds;             ///< median of one evaluation, or of one run
  double over_scalar;             ///< to one force of the same law; 0 for a run
  double over_pinkus_sternlicht;  ///< to the same method of that law
};

/// Times are medians over repeats in which all laws take turns, of random states with ε up to 0.95. A Jacobian is the
/// force with its exact derivatives in ê and u. Pinkus and Sternlicht's rows come first.
/// @param films   tables of one L/D
/// @param golden  data/golden/finite_length/finite_film_force.csv, whose states of that L/D the errors are of
/// @param runs    scenes that are one but for the law of their first joint, Pinkus and Sternlicht's first
/// @param quick   fewer repeats
std::vector<CompiledLawTiming> time_compiled_laws(const std::vector<CompiledFilm>& films,
                                                  const std::filesystem::path& golden, const std::vector<Scene>& runs,
                                                  bool quick);

std::string compiled_law_csv(const std::vector<CompiledLawTiming>& rows);
std::string compiled_law_table(const std::vector<CompiledLawTiming>& rows, double length_to_diameter);

}  // namespace lubjoint::reports
