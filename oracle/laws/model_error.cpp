#include "oracle/laws/model_error.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "lubjoint/film/every_law.hpp"
#include "lubjoint/scene/equilibrium.hpp"
#include "oracle/files/progress.hpp"
#include "oracle/laws/median.hpp"
#include "oracle/reynolds/finite_force.hpp"

namespace lubjoint::reports {

namespace {

constexpr double half_turn = boost::math::constants::pi<double>();

struct Difference {
  double error;
  double uncertainty;
};

Difference difference(const PolarForce<double>& law, const oracle::FiniteLengthResult& film) {
  const double size = std::hypot(film.radial, film.tangential);
  return {std::hypot(law.radial - film.radial, law.tangential - film.tangential) / size,
          std::hypot(film.radial_error, film.tangential_error) / size};
}

}  // namespace

ModelErrorGrid ModelErrorGrid::standard() {
  ModelErrorGrid grid;
  for (int i = 0; i < 10; ++i) grid.eccentricity_ratios.push_back((2 * i + 1) / 20.0);
  return grid;
}

std::vector<ModelErrorEntry> model_error_map(const Bearing<double>& bearing, const ModelErrorGrid& grid) {
  if (grid.directions < 2) throw std::invalid_argument("directions of a model-error map: allowed are 2 or more");
  const Lubricant<double> oil(1.0);  // both forces are linear in it
  std::vector<ModelErrorEntry> map;
  ProgressBar progress("model error", grid.eccentricity_ratios.size() * grid.directions);
  for (const double epsilon : grid.eccentricity_ratios) {
    for (std::size_t i = 0; i < grid.directions; ++i, progress.advance()) {
      const double direction = -half_turn * (1 - static_cast<double>(i) / static_cast<double>(grid.directions - 1));
      const bool radial = i == 0 || i + 1 == grid.directions;  // sin of a rounded half turn is not zero
      const double slip = radial ? 0.0 : -2 * std::sin(direction);
      const PolarFilmState<double> state(epsilon, slip, std::cos(direction));
      for (const oracle::FiniteFilm film : compared_films) {
        const auto force = finite_length_force(film, bearing, oil, state, {grid.relative_tolerance, {}});
        for_each_film_law<EveryFilmLaw>([&]<class Law>() {
          if constexpr (ShapedFilmLaw<Law>) {
            if (length_to_diameter(bearing) > Law::longest) return;
          }
          const Difference d = difference(film_force<Law>(bearing, oil, state), force);
          map.push_back({Law::name, film, epsilon, direction, d.error, d.uncertainty});
        });
      }
    }
  }
  return map;
}

std::vector<ModelErrorSummary> summaries_of(const std::vector<ModelErrorEntry>& map) {
  constexpr std::array<double, 3> bounds = {0.05, 0.10, 0.25};
  std::vector<ModelErrorSummary> summaries;
  for (const oracle::FiniteFilm film : compared_films) {
    for (const std::string_view law : every_law_names) {
      std::vector<double> errors;
      std::array<std::vector<double>, 3> by_direction;
      double first_bad = 1;
      double last_good = 0;
      for (const ModelErrorEntry& entry : map) {
        if (entry.law != law || entry.film != film) continue;
        errors.push_back(entry.error);
        const double along = std::cos(entry.direction);
        by_direction[along >= 0.5 - 1e-9 ? 0 : along <= -0.5 + 1e-9 ? 2 : 1].push_back(entry.error);
        if (std::cos(entry.direction) > -1e-9 && entry.error > 0.25) {
          first_bad = std::min(first_bad, entry.eccentricity_ratio);
        }
      }
      if (errors.empty()) continue;
      for (const ModelErrorEntry& entry : map) {
        if (entry.eccentricity_ratio < first_bad) last_good = std::max(last_good, entry.eccentricity_ratio);
      }
      ModelErrorSummary summary{law, film, median(errors), *std::max_element(errors.begin(), errors.end()), {}, {}, {}};
      const auto share = [](const std::vector<double>& all, double bound) {
        const auto within = std::count_if(all.begin(), all.end(), [bound](double e) { return e <= bound; });
        return all.empty() ? 0.0 : static_cast<double>(within) / static_cast<double>(all.size());
      };
      for (std::size_t i = 0; i < bounds.size(); ++i) {
        summary.share_within[i] = share(errors, bounds[i]);
        for (std::size_t d = 0; d < 3; ++d) summary.by_direction[i][d] = share(by_direction[d], bounds[i]);
      }
      if (last_good > 0) summary.safe_ratio = last_good;
      summaries.push_back(summary);
    }
  }
  return summaries;
}

LoadedState finite_equilibrium(oracle::FiniteFilm film, oracle::FilmOnset onset, const Bearing<double>& bearing,
                               const Lubricant<double>& oil, double load, double spin_sum) {
  if (!(load > 0) || !(spin_sum > 0)) {
    throw std::invalid_argument("equilibrium of a finite-length film: allowed are a load and a spin above 0");
  }
  const oracle::FiniteLengthOptions options{1e-4, onset};
  const auto force = [&](double epsilon) {
    return finite_length_force(film, bearing, oil, PolarFilmState<double>(epsilon, epsilon * spin_sum, 0.0), options);
  };
  const auto excess = [&](double epsilon) {
    const auto f = force(epsilon);
    return std::log(std::hypot(f.radial, f.tangential) / load);
  };
  const double lowest = 1e-6;
  const double highest = 0.99;
  if (excess(lowest) > 0 || excess(highest) < 0) {
    throw std::domain_error("no eccentricity ratio from 1e-6 to 0.99 carries the load with " +
                            std::string(name_of(film)));
  }
  std::uintmax_t iterations = 40;
  const boost::math::tools::eps_tolerance<double> tolerance(17);  // 1e-5: the force is known to 1e-4
  const auto bracket = boost::math::tools::toms748_solve(excess, lowest, highest, tolerance, iterations);
  const double epsilon = (bracket.first + bracket.second) / 2;
  const auto f = force(epsilon);
  std::string name(name_of(film));
  if (onset == oracle::FilmOnset::maximum_film) name += ", onset at the maximum film";
  return {name, epsilon, std::atan2(f.tangential, -f.radial)};
}

std::vector<LoadedState> loaded_states(const Bearing<double>& bearing, const Lubricant<double>& oil, double load,
                                       double spin_sum) {
  // A journal whose only motion is its spin: the sum of the spins is all that the wedge sees.
  Scene scene;
  scene.file = "bearing";
  scene.name = "bearing";
  SceneBody journal;
  journal.name = "journal";
  journal.mass = journal.inertia = 1;
  journal.spin = spin_sum;
  scene.bodies.push_back(journal);
  SceneLoad weight;
  weight.force = {0, -load};
  scene.loads.push_back(weight);
  SceneJoint joint;
  joint.name = "bearing";
  joint.viscosity = oil.viscosity();
  joint.length = bearing.length();
  joint.journal_radius = bearing.radius();
  joint.clearance = bearing.clearance();
  joint.journal.body = 0;
  scene.joints.push_back(joint);
  std::vector<LoadedState> states;
  for (const std::string_view law : film_law_names) {
    scene.joints.front().film = law;
    const JournalEquilibrium rest = journal_equilibrium(scene);
    states.push_back({std::string(law), rest.eccentricity_ratio, rest.attitude});
  }
  using oracle::FilmOnset;
  for (const oracle::FiniteFilm film : compared_films) {
    states.push_back(finite_equilibrium(film, FilmOnset::free, bearing, oil, load, spin_sum));
  }
  states.push_back(
      finite_equilibrium(oracle::FiniteFilm::finite_reynolds, FilmOnset::maximum_film, bearing, oil, load, spin_sum));
  return states;
}

}  // namespace lubjoint::reports
