/// Tables for the joints of scenes whose law is compiled for their L/D.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "lubjoint/scene/scene.hpp"

namespace lubjoint::reports {

/// Gives scenes their tables. Each is asked for once; threads that need one meanwhile wait, so that a compilation has
/// all cores to itself.
class SceneFilms {
 public:
  /// The table of a law for one L/D.
  using Source = std::function<CompiledFilm(const std::string& law, double length_to_diameter)>;

  explicit SceneFilms(Source source) : source_(std::move(source)) {}

  /// Gives each joint of a compiled law the table for its L/D. To be called again where law, length or radius changed.
  /// @throws std::invalid_argument for an L/D for which no film is compiled
  void provide(Scene& scene);

 private:
  std::shared_ptr<const CompiledFilm> table(const std::string& law, double length_to_diameter);

  Source source_;
  std::mutex mutex_;
  std::map<std::pair<std::string, double>, std::shared_ptr<const CompiledFilm>> tables_;
};

/// Says that a journal's film was beyond the places at which its law's stated error was measured; empty if it was not,
/// or if the law is no table.
/// @param farthest  largest |e| of the run [m]
std::string beyond_table_warning(const SceneJoint& joint, double farthest);

}  // namespace lubjoint::reports
