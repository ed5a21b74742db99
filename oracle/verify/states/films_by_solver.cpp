#include "oracle/verify/states/films_by_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <tuple>

#include "oracle/files/parallel.hpp"
#include "oracle/reynolds/film_onset.hpp"
#include "oracle/reynolds/finite_force.hpp"

namespace lubjoint::verify {

namespace {

using oracle::FilmOnset;
using oracle::FiniteFilm;

FiniteFilm film_of(Law law) { return oracle::finite_film_of(name_of(law)); }

/// How a film is solved.
struct Solver {
  FiniteFilm film;
  oracle::FiniteLengthOptions options;
  double b_step;  ///< of differences in b/a, of fourth order
  int nodes;

  Solver(FiniteFilm of, FilmOnset onset) : film(of) {
    const bool on_grids = film == FiniteFilm::finite_reynolds;
    options.relative_tolerance = on_grids ? 1e-4 : 1e-10;
    options.method = oracle::SmoothFilmMethod::circumferential_modes;
    if (on_grids) options.onset = onset;
    // Over which truncation and what the solver's errors differ by are about as large.
    b_step = on_grids ? 0.02 : 0.004;
    nodes = on_grids ? 32 : 44;  // a pole at a distance of π: the error falls by 1.74 with each (more slowly at L/D 4)
  }

  /// Is the force linear in a and b, on one side of a = 0?
  bool is_linear() const { return film == FiniteFilm::finite_full || film == FiniteFilm::finite_half; }

  /// Bound of the error of ∂F/∂b over the largest. @param error  of a force, over |F|
  double difference_error(double error) const {
    if (is_linear()) return 3 * error;
    // Neighbours are solved on one grid: a tenth of their errors is their own (measured: less).
    const double own = film == FiniteFilm::finite_reynolds ? 0.1 * error : error;
    return own / b_step + 1e3 * std::pow(b_step, 4);
  }

  oracle::FiniteForce at(double shape, double ratio, double a, double b) const {
    return oracle::finite_force(film, shape, PolarFilmState<double>(ratio, a, b).in_own_frame(), options);
  }
};

/// What is smooth in log(ε/(1 − ε)), from the centre to the wall: of a = 1, b = 0, F_r(1 − ε)/ε, F_t √(1 − ε),
/// ∂_bF_r (1 − ε)^{3/2} and ∂_bF_t (1 − ε)/ε, which a long bearing's are powers of.
constexpr std::size_t curves = 4;
using Curves = std::array<long double, curves>;

Curves powers(long double ratio, long double gap) {
  return {gap / ratio, std::sqrt(gap), gap * std::sqrt(gap), gap / ratio};
}

/// A film at rest at one L/D.
class RestTable {
 public:
  RestTable(const Solver& solver, double shape, unsigned threads) : nodes_(solver.nodes) {
    const auto n = static_cast<std::size_t>(nodes_);
    std::vector<Curves> values(n);
    std::vector<double> errors(n);
    reports::run_parallel(n, threads, [&](std::size_t j) {
      const double place = std::cos(std::numbers::pi * (static_cast<double>(j) + 0.5) / nodes_);
      std::tie(values[j], errors[j]) = solved(solver, shape, 1 / (1 + std::exp(-(middle + half_width * place))));
    });
    solver_error_ = *std::ranges::max_element(errors);
    difference_error_ = solver.difference_error(solver_error_);
    for (std::size_t c = 0; c < curves; ++c) {
      series_[c].assign(n, 0);
      for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t j = 0; j < n; ++j) {
          const double angle = std::numbers::pi * static_cast<double>(k) * (static_cast<double>(j) + 0.5) / nodes_;
          series_[c][k] += (k == 0 ? 1.0L : 2.0L) / nodes_ * values[j][c] * std::cos(static_cast<long double>(angle));
        }
      }
    }
  }

  SteadySlopes slopes(Real given) const {
    const Real ratio = std::clamp<Real>(given, SolvedFilms::least_ratio, SolvedFilms::largest_ratio);
    const Real gap = 1 - ratio;
    const Real x = (std::log(ratio / gap) - middle) / half_width;
    const Curves scale = powers(ratio, gap);
    Curves value, slope;  // of the rates themselves, and d/dε
    // d ln(scale)/dε: each is ε^p gap^q.
    const Curves by_ratio = {-1 / gap - 1 / ratio, -0.5L / gap, -1.5L / gap, -1 / gap - 1 / ratio};
    for (std::size_t c = 0; c < curves; ++c) {
      const auto [f, df] = sum(series_[c], x);
      value[c] = f / scale[c];
      slope[c] = (df / (half_width * ratio * gap) - f * by_ratio[c]) / scale[c];
    }
    SteadySlopes s;
    s.radial_by_slip = value[0];
    s.tangential_by_slip = value[1];
    s.radial = given * value[0];
    s.tangential = given * value[1];
    s.radial_by_ratio = given * slope[0];
    s.tangential_by_ratio = given * slope[1];
    s.radial_by_squeeze = value[2];
    s.tangential_by_squeeze = value[3];
    if (given > SolvedFilms::largest_ratio) {  // grows on, so that a search for a load knows where it is
      const Real farther = std::sqrt(gap / (1 - given));
      for (Real* f : {&s.radial, &s.tangential, &s.radial_by_slip, &s.tangential_by_slip}) *f *= farther;
    }
    return s;
  }

  RestErrors errors(Real ratio) const {
    const SteadySlopes s = slopes(ratio);
    const Curves scale = powers(ratio, 1 - ratio);
    double tail = 0;  // of the forces' series, over |F|
    for (std::size_t c = 0; c < 2; ++c) {
      for (std::size_t k = series_[c].size() - 3; k < series_[c].size(); ++k) {
        tail += static_cast<double>(ratio / scale[c] / s.size() * std::abs(series_[c][k]));
      }
    }
    RestErrors errors;
    errors.force = solver_error_ + tail;
    // The error at a node is anything up to the solver's; a derivative of a polynomial of degree n through such values
    // is off by n times as much in the middle, where a unit of x is half_width in log(ε/(1 − ε)).
    errors.stiffness = nodes_ / half_width * errors.force;
    errors.damping = difference_error_ + errors.force;
    return errors;
  }

 private:
  /// log(ε/(1 − ε)) at both ends.
  static inline const double low = std::log(SolvedFilms::least_ratio / (1 - SolvedFilms::least_ratio));
  static inline const double high = std::log(SolvedFilms::largest_ratio / (1 - SolvedFilms::largest_ratio));
  static inline const double middle = (low + high) / 2, half_width = (high - low) / 2;

  /// The curves at an ε, and the largest bound of a force's error over |F|.
  static std::pair<Curves, double> solved(const Solver& solver, double shape, double ratio) {
    const auto force = [&](double b) { return solver.at(shape, ratio, 1, b); };
    const oracle::FiniteForce still = force(0);
    double error = still.relative_error();
    const auto vector = [](const Vector2<double>& f) { return Curves{f.x(), f.y(), 0, 0}; };
    const Curves f = vector(still.ratio);
    Curves by_squeeze{};
    const auto add = [&](double b, double weight) {
      const oracle::FiniteForce moving = force(b);
      error = std::max(error, moving.relative_error());
      for (std::size_t k = 0; k < 2; ++k) by_squeeze[k] += weight * vector(moving.ratio)[k];
    };
    if (solver.is_linear()) {
      add(1, 1);
      for (std::size_t k = 0; k < 2; ++k) by_squeeze[k] -= f[k];
    } else {
      const double h = solver.b_step;
      for (const auto& [steps, weight] : {std::pair(1, 8.0), std::pair(2, -1.0)}) {
        add(steps * h, weight / (12 * h));
        add(-steps * h, -weight / (12 * h));
      }
    }
    // The force of the film with a free boundary is a gradient in u = (b, −a/2).
    const bool is_gradient = solver.film == FiniteFilm::finite_reynolds && solver.options.onset == FilmOnset::free;
    if (is_gradient) by_squeeze[1] = -2 * f[0];
    const Curves scale = powers(ratio, 1 - ratio);
    return {{f[0] * scale[0], f[1] * scale[1], by_squeeze[0] * scale[2], by_squeeze[1] * scale[3]}, error};
  }

  /// A Chebyshev series and its derivative (Clenshaw).
  static std::pair<Real, Real> sum(const std::vector<long double>& series, Real x) {
    Real b1 = 0, b2 = 0, d1 = 0, d2 = 0;
    for (std::size_t k = series.size(); k-- > 1;) {
      const Real d = 2 * b1 + 2 * x * d1 - d2;
      d2 = d1;
      d1 = d;
      const Real b = series[k] + 2 * x * b1 - b2;
      b2 = b1;
      b1 = b;
    }
    return {series[0] + x * b1 - b2, b1 + x * d1 - d2};
  }

  int nodes_;
  double solver_error_ = 0;      ///< of forces, over |F|
  double difference_error_ = 0;  ///< of ∂/∂b, over the largest
  std::array<std::vector<long double>, curves> series_;
};

/// L/D to 3e-6 of itself: what a rounding of R or L moves is the same bearing.
long shape_key(Real shape) { return std::lround(std::log2(shape) * 0x1p18L); }

class BySolver final : public SolvedFilms {
 public:
  BySolver(FilmOnset onset, unsigned threads) : onset_(onset), threads_(threads) {}

  SteadySlopes slopes(Law film, Real shape, Real ratio) const override { return table(film, shape).slopes(ratio); }
  RestErrors errors_at_rest(Law film, Real shape, Real ratio) const override {
    return table(film, shape).errors(ratio);
  }

  SolvedForce force(Law law, Real shape, Real ratio, Real a, Real b) const override {
    const UnitFilm unit(law, shape, ratio, a, b);
    if (unit.rate == 0) return {};
    SolvedForce force = once(forces_, unit.key(), [&] {
      const Solver solver(film_of(law), onset_);
      const oracle::FiniteForce solved =
          oracle::finite_force(solver.film, unit.shape, unit.state().in_own_frame(), solver.options);
      return SolvedForce{solved.ratio.x(), solved.ratio.y(), solved.relative_error() + UnitFilm::rounding};
    });
    force.radial *= unit.rate;
    force.tangential *= unit.rate;
    return force;
  }

  SolvedCosts costs(Law law, Real shape, Real ratio, Real a, Real b) const override {
    const UnitFilm unit(law, shape, ratio, a, b);
    if (unit.rate == 0) return {};
    SolvedCosts costs = once(costs_, unit.key(), [&] {
      Solver solver(film_of(law), onset_);
      const FilmState<double> state = unit.state().in_own_frame();
      if (solver.film != FiniteFilm::finite_reynolds) solver.options.relative_tolerance = 1e-9;
      const oracle::FiniteFlow flow = oracle::finite_side_flow(solver.film, unit.shape, state, solver.options);
      SolvedCosts solved;
      solved.side_flow = flow.ratio;
      solved.flow_error = flow.error / std::hypot(unit.a, 2 * unit.b) + UnitFilm::rounding;
      if (solver.film == FiniteFilm::finite_reynolds) {
        const oracle::FiniteCouette couette = oracle::finite_couette_integral(unit.shape, state, 1e-4);
        solved.couette_integral = couette.integral;
        solved.couette_error = couette.error / couette.integral + UnitFilm::rounding;
      }
      return solved;
    });
    costs.side_flow *= unit.rate;
    return costs;
  }

  SolvedPressure pressure(Law law, Real shape, Real ratio, Real a, Real b, Real theta, Real zeta) const override {
    const UnitFilm unit(law, shape, ratio, a, b);
    if (unit.rate == 0) return {};
    const auto key = std::tuple_cat(unit.key(), std::tuple(static_cast<double>(theta), UnitFilm::rounded(zeta)));
    SolvedPressure pressure = once(pressures_, key, [&] {
      const oracle::FinitePressure solved = oracle::finite_pressure(
          film_of(law), unit.shape, unit.state(), static_cast<double>(theta), UnitFilm::rounded(zeta), onset_);
      return SolvedPressure{solved.ratio, solved.largest,
                            (solved.largest > 0 ? solved.error / solved.largest : 0) + UnitFilm::rounding};
    });
    pressure.pressure *= unit.rate;
    pressure.largest *= unit.rate;
    return pressure;
  }

  const SolvedFilms& with_other_onset() const override {  // kept as long as the process
    return *solved_films(onset_ == FilmOnset::free ? FilmOnset::maximum_film : FilmOnset::free, threads_);
  }

 private:
  /// A state at the rate one, to 36 digits of two: what a mistake multiplies with is the same film.
  struct UnitFilm {
    static constexpr double rounding = 1e-9;  ///< what that moves of a force or a flow, with room
    static double rounded(Real x) { return static_cast<double>(std::round(x * 0x1p36L) * 0x1p-36L); }

    std::size_t law;
    double shape, ratio;
    Real rate;    ///< the larger of |a| and |b|
    double a, b;  ///< over it

    UnitFilm(Law film, Real of_shape, Real of_ratio, Real slip, Real squeeze)
        : law(film.place),
          shape(rounded(of_shape)),
          ratio(rounded(of_ratio)),
          rate(std::max(std::abs(slip), std::abs(squeeze))),
          a(rate > 0 ? rounded(slip / rate) : 0),
          b(rate > 0 ? rounded(squeeze / rate) : 0) {}

    PolarFilmState<double> state() const { return PolarFilmState<double>(ratio, a, b); }
    std::tuple<std::size_t, double, double, double, double> key() const { return {law, shape, ratio, a, b}; }
  };

  /// What was found, or is found and kept.
  template <class Map, class Solve>
  typename Map::mapped_type once(Map& kept, const typename Map::key_type& key, const Solve& solve) const {
    {
      const std::lock_guard lock(mutex_);
      if (const auto found = kept.find(key); found != kept.end()) return found->second;
    }
    const typename Map::mapped_type solved = solve();
    const std::lock_guard lock(mutex_);
    return kept.emplace(key, solved).first->second;
  }

  const RestTable& table(Law law, Real shape) const {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<RestTable>& place = tables_[{law.place, shape_key(shape)}];
    if (!place) {
      place = std::make_unique<RestTable>(Solver(film_of(law), onset_), static_cast<double>(shape), threads_);
    }
    return *place;
  }

  FilmOnset onset_;
  unsigned threads_;
  mutable std::mutex mutex_;
  mutable std::map<std::pair<std::size_t, long>, std::unique_ptr<RestTable>> tables_;
  using Film = std::tuple<std::size_t, double, double, double, double>;
  mutable std::map<Film, SolvedForce> forces_;
  mutable std::map<Film, SolvedCosts> costs_;
  mutable std::map<std::tuple<std::size_t, double, double, double, double, double, double>, SolvedPressure> pressures_;
};

}  // namespace

std::shared_ptr<const SolvedFilms> solved_films(FilmOnset onset, unsigned threads) {
  static std::map<FilmOnset, std::shared_ptr<const SolvedFilms>> made;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  std::shared_ptr<const SolvedFilms>& films = made[onset];
  if (!films) films = std::make_shared<BySolver>(onset, threads);
  return films;
}

}  // namespace lubjoint::verify
