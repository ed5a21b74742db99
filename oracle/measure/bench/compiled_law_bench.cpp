#include "oracle/measure/bench/compiled_law_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/film/pinkus_sternlicht.hpp"
#include "lubjoint/number/dual.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/progress.hpp"
#include "oracle/measure/bench/random_states.hpp"
#include "oracle/measure/timing.hpp"

namespace lubjoint::reports {

namespace {

constexpr double limit = 0.95;  // of ε: what every table states its error for
constexpr std::array methods = {"scalar", "jacobian", "batch"};

/// Pinkus and Sternlicht's as an object, as the tables are.
struct Reference {
  template <class T>
  Vector2<T> operator()(const FilmState<T>& film) const {
    return force_ratio<PinkusSternlicht>(film);
  }
  void batch(RandomStates& s) const { film_force_ratios(PinkusSternlicht::name, s.in(), s.out()); }
};

template <class Law>
struct Table {
  const Law& law;
  AnyCompiledLaw any;

  template <class T>
  Vector2<T> operator()(const FilmState<T>& film) const {
    return compiled_force_ratio(law, film);
  }
  void batch(RandomStates& s) const { film_force_ratios(any, s.in(), s.out()); }
};

/// The three pieces of work of a law, in the order of methods.
template <class Force>
void add_work(const Force& force, RandomStates& s, double& sink, std::vector<std::function<void()>>& work) {
  const auto add = [&work](const auto& call) {
    work.push_back([call] {
      for (int i = 0; i < timed_calls; ++i) call();
    });
  };
  add([&s, force] {
    for (std::size_t i = 0; i < s.rows(); ++i) {
      const Vector2<double> f = force(FilmState<double>({s.ex[i], s.ey[i]}, {s.ux[i], s.uy[i]}));
      s.first[i] = f.x();
      s.second[i] = f.y();
    }
  });
  add([&s, &sink, force] {
    using D = Dual<double, 4>;
    double sum = 0;
    for (std::size_t i = 0; i < s.rows(); ++i) {
      const Vector2<D> e(D::variable(s.ex[i], 0), D::variable(s.ey[i], 1));
      const Vector2<D> u(D::variable(s.ux[i], 2), D::variable(s.uy[i], 3));
      const Vector2<D> f = force(FilmState<D>(e, u));
      sum += f.x().derivatives().sum() + f.y().derivatives().sum();
    }
    sink += sum;
  });
  add([&s, force] { force.batch(s); });
}

/// Sets the errors of a table's force, from the golden states of its film and L/D.
template <class Law>
void measure_errors(const Law& law, const CsvTable& golden, CompiledLawTiming& row) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < golden.rows(); ++i) {
    const auto number = [&](const char* name) { return golden.number(i, golden.column(name)); };
    if (golden.field(i, golden.column("film")) != Law::name || number("length_over_diameter") != law.shape()) continue;
    const PolarFilmState<double> state(number("eccentricity_ratio"), number("slip_rate"), number("squeeze_rate"));
    if (state.eccentricity_ratio > limit) continue;
    const PolarForce<double> force = compiled_polar_force_ratio(law, state);
    const double radial = number("radial"), tangential = number("tangential");
    errors.push_back(std::hypot(force.radial - radial, force.tangential - tangential) / std::hypot(radial, tangential));
  }
  row.states = errors.size();
  if (errors.empty()) return;
  row.largest_error = *std::ranges::max_element(errors);
  row.median_error = median_of(std::move(errors));
}

}  // namespace

std::vector<CompiledLawTiming> time_compiled_laws(const std::vector<CompiledFilm>& films,
                                                  const std::filesystem::path& golden, const std::vector<Scene>& runs,
                                                  bool quick) {
  const CsvTable forces(read_input(golden.string()), golden.string());
  RandomStates s(timed_rows, limit);
  double sink = 0;
  std::vector<AnyCompiledLaw> laws;
  for (const CompiledFilm& film : films) {
    with_compiled_law(film, [&laws](const auto& law) { laws.emplace_back(law); });
  }
  std::vector<std::function<void()>> work;
  std::vector<CompiledLawTiming> rows;
  const auto add_rows = [&rows](std::string_view law) {
    for (const char* method : methods) rows.push_back({std::string(law), method, 0, 0, 0, 0, 0, 0});
  };
  add_work(Reference{}, s, sink, work);
  add_rows(PinkusSternlicht::name);
  for (const AnyCompiledLaw& any : laws) {
    std::visit(
        [&]<class Law>(const Law& law) {
          add_work(Table<Law>{law, any}, s, sink, work);
          add_rows(Law::name);
          CompiledLawTiming& scalar = rows[rows.size() - methods.size()];
          CompiledLawTiming& batch = rows.back();
          measure_errors(law, forces, scalar);
          measure_errors(law, forces, batch);  // its bits are the same
        },
        any);
  }
  ProgressBar progress("compiled laws", 2);
  const std::vector<double> times = interleaved_medians(quick ? 51 : 301, work);
  if (!std::isfinite(sink)) throw std::logic_error("a film's force has a derivative that is no number");
  progress.advance();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].nanoseconds = times[i] / (static_cast<double>(timed_rows) * timed_calls);
    rows[i].over_scalar = times[i] / times[i - i % methods.size()];
    rows[i].over_pinkus_sternlicht = times[i] / times[i % methods.size()];
  }
  std::vector<std::function<void()>> simulations;
  for (const Scene& scene : runs) {
    simulations.push_back([&scene] {
      const RunOutcome outcome = simulate_multibody(scene).outcome;
      if (outcome.status == RunStatus::finished) return;
      throw std::runtime_error("the scene " + scene.name + " stops with the law " + scene.joints.front().film);
    });
  }
  const std::vector<double> run_times = interleaved_medians(quick ? 3 : 21, simulations);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    rows.push_back({runs[i].joints.front().film, "simulate", 0, 0, 0, run_times[i], 0, run_times[i] / run_times[0]});
  }
  progress.advance();
  return rows;
}

std::string compiled_law_csv(const std::vector<CompiledLawTiming>& rows) {
  std::string csv = "law,method,states,median_error,largest_error,nanoseconds,over_scalar,over_pinkus_sternlicht\n";
  for (const CompiledLawTiming& t : rows) {
    const std::string errors = t.states > 0 ? fmt::format("{:.3e},{:.3e}", t.median_error, t.largest_error) : ",";
    const std::string over = t.over_scalar > 0 ? fmt::format("{:.4g}", t.over_scalar) : "";
    csv += fmt::format("{},{},{},{},{:.4g},{},{:.4g}\n", t.law, t.method, t.states, errors, t.nanoseconds, over,
                       t.over_pinkus_sternlicht);
  }
  return csv;
}

std::string compiled_law_table(const std::vector<CompiledLawTiming>& rows, double length_to_diameter) {
  std::string text = fmt::format("{:<18} {:<10} {:>7} {:>10} {:>10} {:>14} {:>8} {:>20}\n", "law", "method", "states",
                                 "median", "largest", "time [ns]", "/ force", "/ Pinkus-Sternlicht");
  for (const CompiledLawTiming& t : rows) {
    const std::string errors = t.states > 0 ? fmt::format("{:>10.1e} {:>10.1e}", t.median_error, t.largest_error)
                                            : fmt::format("{:>10} {:>10}", "", "");
    const std::string over = t.over_scalar > 0 ? fmt::format("{:.3g}", t.over_scalar) : "";
    text += fmt::format("{:<18} {:<10} {:>7} {} {:>14.1f} {:>8} {:>20.3g}\n", t.law, t.method, t.states, errors,
                        t.nanoseconds, over, t.over_pinkus_sternlicht);
  }
  return text +
         fmt::format(
             "Tables for L/D {:.3g}; errors over |F| against the golden forces of that L/D. A Jacobian is the "
             "force with its derivatives in e and u;\nsimulate is a whole run of the slider-crank of the paper.\n",
             length_to_diameter);
}

}  // namespace lubjoint::reports
