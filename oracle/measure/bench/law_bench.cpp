#include "oracle/measure/bench/law_bench.hpp"

#include <fmt/format.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "lubjoint/film/every_law.hpp"
#include "lubjoint/film/mobility.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/progress.hpp"
#include "oracle/measure/bench/divide_bound.hpp"
#include "oracle/measure/bench/random_states.hpp"
#include "oracle/measure/timing.hpp"
#include "oracle/reynolds/film_integral.hpp"
#include "oracle/reynolds/finite_length.hpp"

namespace lubjoint::reports {

namespace {

using Exact = boost::multiprecision::cpp_bin_float_quad;  // 34 digits; the golden values have 30

struct GoldenForce {
  std::string law;
  std::array<double, 4> bearing;  ///< viscosity, length, radius, clearance
  std::array<double, 3> state;    ///< ε, a, b
  Exact radial, tangential;
};

std::vector<GoldenForce> read_golden(const std::filesystem::path& file) {
  const CsvTable table(read_input(file.string()), file.string());
  std::vector<GoldenForce> forces;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto number = [&](const char* name) { return table.number(row, table.column(name)); };
    const auto exact = [&](const char* name) { return Exact(std::string(table.field(row, table.column(name)))); };
    forces.push_back({std::string(table.field(row, table.column("law"))),
                      {number("viscosity"), number("length"), number("radius"), number("clearance")},
                      {number("eccentricity_ratio"), number("slip_rate"), number("squeeze_rate")},
                      exact("radial"),
                      exact("tangential")});
  }
  return forces;
}

template <class R>
Bearing<R> bearing_of(const GoldenForce& g) {
  return {R(g.bearing[1]), R(g.bearing[2]), R(g.bearing[3])};
}

template <class R>
PolarFilmState<R> state_of(const GoldenForce& g) {
  return {R(g.state[0]), R(g.state[1]), R(g.state[2])};
}

/// Sets the errors of a row of the table, from every stride-th golden state of its law that is wanted.
template <class Wanted, class Force>
void measure_errors(LawTiming& row, const std::vector<GoldenForce>& golden, std::size_t stride, const Wanted& wanted,
                    const Force& force) {
  std::vector<double> errors;
  std::size_t seen = 0;
  for (const GoldenForce& g : golden) {
    if (g.law != row.law || !wanted(g) || seen++ % stride != 0) continue;
    const auto [radial, tangential] = force(g);
    const Exact size = sqrt(Exact(g.radial * g.radial + g.tangential * g.tangential));
    const Exact dr = Exact(radial) - g.radial;
    const Exact dt = Exact(tangential) - g.tangential;
    const Exact distance = sqrt(Exact(dr * dr + dt * dt));
    errors.push_back(static_cast<double>(size > 0 ? Exact(distance / size) : distance));
  }
  row.states = errors.size();
  row.largest_error = *std::ranges::max_element(errors);
  row.median_error = median_of(std::move(errors));
}

bool any_state(const GoldenForce&) { return true; }

bool has_moderate_rates(const GoldenForce& g) {
  const double rate = std::abs(g.state[1]) + std::abs(g.state[2]);
  return rate == 0 || (rate > 1e-100 && rate < 1e100);
}

/// What a finite-length film is compared at: the paper's bearing, and no closer to the wall than its grids like.
bool is_of_the_paper(const GoldenForce& g) {
  return g.bearing[1] == 0.04 && g.bearing[2] == 0.0098 && g.state[0] >= 0.1 && g.state[0] <= 0.9 &&
         has_moderate_rates(g) && (g.radial != 0 || g.tangential != 0);
}

/// What a law's pressure is integrated at: where it has a force.
template <FilmLaw Law>
bool has_integral(const GoldenForce& g) {
  return has_moderate_rates(g) && (!SqueezeOnlyLaw<Law> || g.radial != 0);
}

/// Where a law is compared with a film of finite length: a law of the squeeze alone where there is no wedge.
template <FilmLaw Law>
bool has_film_of_the_paper(const GoldenForce& g) {
  return is_of_the_paper(g) && (!SqueezeOnlyLaw<Law> || g.state[1] == 0);
}

oracle::FiniteFilm finite_film(FilmExtent extent) {
  if (extent == FilmExtent::full) return oracle::FiniteFilm::finite_full;
  return extent == FilmExtent::half ? oracle::FiniteFilm::finite_half : oracle::FiniteFilm::finite_dynamic;
}

const Bearing<double> unit_bearing(1, 1, 0.5);
const Lubricant<double> unit_oil(1);

/// F/S of all states, one after the other.
template <FilmLaw Law, class R>
void evaluate_singly(const RandomStates& s, std::vector<R>& first, std::vector<R>& second) {
  for (std::size_t i = 0; i < s.rows(); ++i) {
    const FilmState<R> film({R(s.ex[i]), R(s.ey[i])}, {R(s.ux[i]), R(s.uy[i])});
    const Vector2<R> ratio = force_ratio<Law>(film);
    first[i] = ratio.x();
    second[i] = ratio.y();
  }
}

struct Repeats {
  int fast;     ///< of closed forms
  int slow;     ///< of pressure solutions
  int stride;   ///< through the golden states, for quadrature
  int finites;  ///< golden states that are solved for finite length
};

/// Medians of one evaluation: the bound, then of each law scalar, batch and long double. All of them take turns.
std::vector<double> time_closed_forms(int repeats) {
  RandomStates s(timed_rows, 0.97);
  RandomStates positive(timed_rows, 0.97);
  for (std::vector<double>* column : {&positive.epsilon, &positive.ex, &positive.ey, &positive.ux}) {
    for (double& x : *column) x = 1 + std::abs(x);
  }
  std::vector<long double> wide_first(timed_rows);
  std::vector<long double> wide_second(timed_rows);
  std::vector<std::function<void()>> work;
  const auto add = [&work](const auto& call) {
    work.push_back([call] {
      for (int i = 0; i < timed_calls; ++i) call();
    });
  };
  add([&] {
    two_roots_and_a_quotient(timed_rows, positive.epsilon.data(), positive.ex.data(), positive.ey.data(),
                             positive.ux.data(), positive.first.data(), fastest_instruction_set());
  });
  for_each_film_law<StateFilmLaws>([&]<class Law>() {
    add([&] { evaluate_singly<Law>(s, s.first, s.second); });
    add([&] { film_force_ratios(Law::name, FilmStateArrays{s.ex, s.ey, s.ux, s.uy}, s.out()); });
    add([&] { evaluate_singly<Law>(s, wide_first, wide_second); });
  });
  std::vector<double> times = interleaved_medians(repeats, work);
  for (double& time : times) time /= static_cast<double>(timed_rows) * timed_calls;
  return times;
}

/// @param times  the law's three of time_closed_forms
template <FilmLaw Law>
void judge_closed_forms(LawBench& bench, const std::vector<GoldenForce>& golden, const double* times) {
  const std::string law(Law::name);
  LawTiming scalar{law, "scalar", 0, 0, 0, times[0]};
  measure_errors(scalar, golden, 1, any_state, [](const GoldenForce& g) {
    return film_force<Law>(bearing_of<double>(g), Lubricant<double>(g.bearing[0]), state_of<double>(g));
  });
  LawTiming batch{law, "batch", 0, 0, 0, times[1]};
  measure_errors(batch, golden, 1, any_state, [](const GoldenForce& g) {
    PolarForce<double> force;
    const auto one = [](const double& x) { return std::span<const double>(&x, 1); };
    film_forces(Law::name, bearing_of<double>(g), Lubricant<double>(g.bearing[0]),
                PolarStateArrays{one(g.state[0]), one(g.state[1]), one(g.state[2])},
                {{&force.radial, 1}, {&force.tangential, 1}});
    return force;
  });
  LawTiming wide{law, "long_double", 0, 0, 0, times[2]};
  measure_errors(wide, golden, 1, any_state, [](const GoldenForce& g) {
    return film_force<Law>(bearing_of<long double>(g), Lubricant<long double>(g.bearing[0]), state_of<long double>(g));
  });
  bench.laws.insert(bench.laws.end(), {scalar, batch, wide});
}

/// The film whose pressure a law integrates: that of its extent, which a law of the squeeze alone sees at a = 0.
template <FilmLaw Law>
std::string_view pressure_of() {
  if constexpr (!SqueezeOnlyLaw<Law>) return Law::name;
  const bool is_short = Law::limit == BearingLimit::short_bearing;
  if (Law::extent == FilmExtent::full) return is_short ? ShortFull::name : LongFull::name;
  return is_short ? ShortDynamic::name : LongDynamic::name;
}

/// The pressure solutions.
template <FilmLaw Law>
void time_pressures(LawBench& bench, const std::vector<GoldenForce>& golden, const Repeats& repeats) {
  const std::string law(Law::name);
  const auto time_of = [](int times, const auto& states, const auto& force) {
    const auto all = [&] {
      for (const GoldenForce* g : states) force(*g);
    };
    return interleaved_medians(times, {all}).front() / static_cast<double>(states.size());
  };
  const auto every = [&](std::size_t most, const auto& wanted) {
    std::vector<const GoldenForce*> chosen;
    for (const GoldenForce& g : golden) {
      if (g.law == law && wanted(g)) chosen.push_back(&g);
    }
    std::vector<const GoldenForce*> spread;
    for (std::size_t i = 0; i < std::min(most, chosen.size()); ++i) {
      spread.push_back(chosen[i * chosen.size() / std::min(most, chosen.size())]);
    }
    return spread;
  };
  if constexpr (Law::has_pressure) {
    const auto film = oracle::one_dimensional_film(pressure_of<Law>());
    const auto force = [film](const GoldenForce& g) {
      const auto f = film_force_by_quadrature(film, bearing_of<double>(g), Lubricant<double>(g.bearing[0]),
                                              state_of_film<Law>(state_of<double>(g)));
      return PolarForce<double>{f.radial.value, f.tangential.value};
    };
    LawTiming row{law, "quadrature", 0, 0, 0, time_of(repeats.slow, every(64, has_film_of_the_paper<Law>), force)};
    measure_errors(row, golden, static_cast<std::size_t>(repeats.stride), has_integral<Law>, force);
    bench.laws.push_back(row);
  }
  const auto force = [](const GoldenForce& g) {
    const auto f = finite_length_force(finite_film(Law::extent), bearing_of<double>(g), Lubricant<double>(g.bearing[0]),
                                       state_of<double>(g));
    return PolarForce<double>{f.radial, f.tangential};
  };
  const auto states = every(static_cast<std::size_t>(repeats.finites), has_film_of_the_paper<Law>);
  LawTiming row{law, "finite_length", 0, 0, 0, time_of(repeats.slow, states, force)};
  const auto is_solved = [&](const GoldenForce& g) { return std::ranges::find(states, &g) != states.end(); };
  measure_errors(row, golden, 1, is_solved, force);
  bench.laws.push_back(row);
}

/// The inverse, of laws that have one velocity for every force: over random states, the error |M(F(u)) − u| over |u|.
template <FilmLaw Law>
void time_mobility(LawBench& bench, const Repeats& repeats) {
  if constexpr (Law::extent != FilmExtent::half && !SqueezeOnlyLaw<Law>) {
    RandomStates s(timed_rows, 0.97);
    std::vector<Vector2<double>> forces;
    std::vector<double> errors;
    for (std::size_t i = 0; i < s.rows(); ++i) {
      const FilmState<double> film({s.ex[i], s.ey[i]}, {s.ux[i], s.uy[i]});
      forces.push_back(force_ratio<Law>(film));
      const Vector2<double> u = *mobility<Law>(film.eccentricity, film.q, forces.back()).velocity;
      errors.push_back((u - film.velocity).norm());
    }
    const auto all = [&] {
      for (std::size_t i = 0; i < s.rows(); ++i) {
        const Vector2<double> e(s.ex[i], s.ey[i]);
        const Vector2<double> u = *mobility<Law>(e, one_minus_squared_norm(s.ex[i], s.ey[i]), forces[i]).velocity;
        s.first[i] = u.x();
        s.second[i] = u.y();
      }
    };
    const double time = interleaved_medians(repeats.fast, {all}).front() / static_cast<double>(timed_rows);
    LawTiming row{std::string(Law::name), "mobility", errors.size(), 0, 0, time};
    row.largest_error = *std::ranges::max_element(errors);
    row.median_error = median_of(std::move(errors));
    bench.laws.push_back(row);
  }
}

BatchTiming time_batches(std::size_t rows, int repeats) {
  RandomStates s(rows, 0.97);
  const std::vector<double> still(rows, 0.0);
  const std::vector<double> spin(rows, 1.0);
  constexpr std::string_view law = "pinkus_sternlicht";
  // A clearance of 1 m, so that the random ê and u are e and v as well.
  const Bearing<double> wide_bearing(1, 2, 1);
  const std::size_t calls = std::max<std::size_t>(1, 10000 / rows);
  const auto many = [&](const auto& call) {
    return [&s, calls, call] {
      for (std::size_t i = 0; i < calls; ++i) call(s);
    };
  };
  const auto of_states = [&](RandomStates& r) {
    film_forces(law, unit_bearing, unit_oil, FilmStateArrays{r.ex, r.ey, r.ux, r.uy}, r.out());
  };
  const auto of_polar = [&](RandomStates& r) {
    film_forces(law, unit_bearing, unit_oil, PolarStateArrays{r.epsilon, r.ux, r.uy}, r.out());
  };
  const auto of_motions = [&](RandomStates& r) {
    film_forces(law, wide_bearing, unit_oil, JournalMotionArrays{r.ex, r.ey, r.ux, r.uy, still, spin}, r.out());
  };
  const std::vector<double> times = interleaved_medians(repeats, {many(of_states), many(of_polar), many(of_motions)});
  const double forces = static_cast<double>(rows * calls);
  return {rows, times[0] / forces, times[1] / forces, times[2] / forces};
}

const LawTiming& find(const LawBench& bench, const std::string& law, const std::string& method) {
  return *std::ranges::find_if(bench.laws, [&](const LawTiming& t) { return t.law == law && t.method == method; });
}

}  // namespace

LawBench time_laws(const std::filesystem::path& golden_file, bool quick) {
  const std::vector<GoldenForce> golden = read_golden(golden_file);
  const Repeats repeats = quick ? Repeats{51, 9, 8, 4} : Repeats{301, 21, 1, 16};
  const std::vector<std::size_t> sizes{1'000, 10'000, 100'000, 1'000'000};
  ProgressBar progress("laws", 1 + names_of_laws<StateFilmLaws>.size() + sizes.size());
  const std::vector<double> times = time_closed_forms(repeats.fast);
  progress.advance();
  LawBench bench{times[0], {}, {}};
  const double* of_law = &times[1];
  for_each_film_law<StateFilmLaws>([&]<class Law>() {
    judge_closed_forms<Law>(bench, golden, of_law);
    time_mobility<Law>(bench, repeats);
    time_pressures<Law>(bench, golden, repeats);
    of_law += 3;
    progress.advance();
  });
  for (const std::size_t rows : sizes) {
    bench.batches.push_back(time_batches(rows, rows < 1'000'000 ? repeats.fast : 21));
    progress.advance();
  }
  return bench;
}

std::string law_bench_csv(const LawBench& bench) {
  std::string csv = "law,method,states,median_error,largest_error,nanoseconds,over_bound,over_batch\n";
  for (const LawTiming& t : bench.laws) {
    csv += fmt::format("{},{},{},{:.3e},{:.3e},{:.4g},{:.4g},{:.4g}\n", t.law, t.method, t.states, t.median_error,
                       t.largest_error, t.nanoseconds, t.nanoseconds / bench.bound,
                       t.nanoseconds / find(bench, t.law, "batch").nanoseconds);
  }
  return csv;
}

std::string batch_csv(const LawBench& bench) {
  std::string csv = "law,rows,nanoseconds_states,nanoseconds_polar,nanoseconds_motions\n";
  for (const BatchTiming& t : bench.batches) {
    csv += fmt::format("pinkus_sternlicht,{},{:.4g},{:.4g},{:.4g}\n", t.rows, t.states, t.polar, t.motions);
  }
  return csv;
}

std::string law_bench_table(const LawBench& bench) {
  std::string text = fmt::format("{:<18} {:<14} {:>7} {:>10} {:>10} {:>12} {:>8} {:>8}\n", "law", "method", "states",
                                 "median", "largest", "time [ns]", "/ bound", "/ batch");
  for (const LawTiming& t : bench.laws) {
    text += fmt::format("{:<18} {:<14} {:>7} {:>10.1e} {:>10.1e} {:>12.2f} {:>8.3g} {:>8.3g}\n", t.law, t.method,
                        t.states, t.median_error, t.largest_error, t.nanoseconds, t.nanoseconds / bench.bound,
                        t.nanoseconds / find(bench, t.law, "batch").nanoseconds);
  }
  const double batch = find(bench, "pinkus_sternlicht", "batch").nanoseconds;
  const double scalar = find(bench, "pinkus_sternlicht", "scalar").nanoseconds;
  text += fmt::format(
      "Errors over |F| against the certified values; for finite_length the model error of the law, for mobility how "
      "far\n"
      "the velocity that carries F(u) is from u.\n"
      "Bound: two square roots and a division, {}: {:.2f} ns. Pinkus-Sternlicht: batch {:.2f} times the bound, scalar "
      "{:.2f} times the batch.\n\n",
      name_of(fastest_instruction_set()), bench.bound, batch / bench.bound, scalar / batch);
  text += fmt::format("{:<18} {:>10} {:>12} {:>12} {:>12}   [ns a row]\n", "batch", "rows", "e, u", "polar", "motion");
  for (const BatchTiming& t : bench.batches) {
    text += fmt::format("{:<18} {:>10} {:>12.2f} {:>12.2f} {:>12.2f}\n", "pinkus_sternlicht", t.rows, t.states, t.polar,
                        t.motions);
  }
  return text;
}

}  // namespace lubjoint::reports
