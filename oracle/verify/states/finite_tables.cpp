#include "oracle/verify/states/finite_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <tuple>

#include "oracle/files/parallel.hpp"
#include "oracle/reynolds/film_onset.hpp"
#include "oracle/reynolds/finite_force.hpp"
#include "oracle/verify/states/finite_film.hpp"
#include "oracle/verify/states/steady_slopes.hpp"

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

  MovingFilm moving(Law law, Real shape, Real ratio, Real a, Real b) const override {
    if (a == 0 && b == 0) return {};
    const auto key = std::tuple(law.place, static_cast<double>(shape), static_cast<double>(ratio),
                                static_cast<double>(a), static_cast<double>(b));
    {
      const std::lock_guard lock(mutex_);
      if (const auto found = moving_.find(key); found != moving_.end()) return found->second;
    }
    const MovingFilm film =
        solved(film_of(law), static_cast<double>(shape),
               PolarFilmState<double>(static_cast<double>(ratio), static_cast<double>(a), static_cast<double>(b)));
    const std::lock_guard lock(mutex_);
    return moving_.emplace(key, film).first->second;
  }

 private:
  static MovingFilm solved(FiniteFilm film, double shape, const PolarFilmState<double>& polar) {
    Solver solver(film, FilmOnset::free);
    const FilmState<double> state = polar.in_own_frame();
    const oracle::FiniteForce force = oracle::finite_force(film, shape, state, solver.options);
    if (film != FiniteFilm::finite_reynolds) solver.options.relative_tolerance = 1e-9;
    const oracle::FiniteFlow flow = oracle::finite_side_flow(film, shape, state, solver.options);
    MovingFilm result;
    result.radial = force.ratio.x();
    result.tangential = force.ratio.y();
    result.side_flow = flow.ratio;
    result.force_error = force.relative_error();
    result.flow_error = flow.error / std::hypot(polar.slip_rate, 2 * polar.squeeze_rate);
    if (film == FiniteFilm::finite_reynolds) {
      const oracle::FiniteCouette couette = oracle::finite_couette_integral(shape, state, 1e-4);
      result.couette_integral = couette.integral;
      result.couette_error = couette.error / couette.integral;
    }
    return result;
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
  mutable std::map<std::tuple<std::size_t, double, double, double, double>, MovingFilm> moving_;
};

/// A journal that carries a load, at about this ε: short and long half films as springs in series.
State load_at(double shape, double ratio, double spin, std::size_t place) {
  State s;
  s.radius = 0.01 * (1 + static_cast<double>(place % 4));
  s.length = 2 * s.radius * shape;
  s.clearance = s.radius / 512;
  s.viscosity = 0.02 + 0.01 * static_cast<double>(place % 5);
  s.omega = spin * (1 + 0.1 * static_cast<double>(place % 7));
  const auto over_scale = [&](Law law) { return published_slopes(law, ratio, 1 - ratio).size(); };
  const Real slenderness = 2 * static_cast<Real>(shape);
  const Real load =
      1 / (1 / (over_scale("short_half"_law) * slenderness * slenderness) + 1 / over_scale("long_half"_law));
  const double scale = force_scale(BearingLimit::long_bearing, Bearing<double>(s.length, s.radius, s.clearance),
                                   Lubricant<double>(s.viscosity));
  s.load = static_cast<double>(load) * scale * std::abs(s.omega);
  return s;
}

std::vector<State> loads() {
  std::vector<State> states;
  for (const double shape : finite_shapes) {
    for (const double ratio : {0.1, 0.25, 0.4, 0.55, 0.7, 0.8, 0.9}) {
      for (const double spin : {200.0, -300.0}) states.push_back(load_at(shape, ratio, spin, states.size()));
    }
  }
  return states;
}

}  // namespace

std::shared_ptr<const SolvedFilms> solved_films(FilmOnset onset, unsigned threads) {
  static std::map<FilmOnset, std::shared_ptr<const SolvedFilms>> made;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  std::shared_ptr<const SolvedFilms>& films = made[onset];
  if (!films) films = std::make_shared<BySolver>(onset, threads);
  return films;
}

std::vector<State> finite_table_states(const FiniteClaim& claim, Quantities quantities, const Conjunction& domain,
                                       ShearExtent shear, unsigned threads) {
  if (!is_table(quantities)) {
    throw std::invalid_argument("the quantities " + std::string(name_of(quantities)) +
                                " are no table; allowed are coefficients, equilibrium and losses");
  }
  if (claim.onset == FilmOnset::maximum_film && quantities != Quantities::equilibrium) {
    throw std::invalid_argument("an onset at the maximum film is pinned in steady rotation alone, and " +
                                std::string(name_of(quantities)) +
                                " ask for films in squeeze; allowed with it are cartesian, polar and equilibrium");
  }
  std::vector<State> states;
  if (is_of_load(quantities)) {
    states = loads();
    std::erase_if(states, [&domain](const State& state) { return !holds(domain, state); });
    if (states.empty()) {
      throw std::invalid_argument("no state of a film of finite length has " + words(domain) +
                                  "; allowed is a domain that holds one of them");
    }
  } else {
    states = finite_states(Quantities::cartesian, domain);
  }
  const auto films = solved_films(claim.onset, threads);
  for (State& state : states) {
    state.films = films;
    state.shear = shear;
  }
  return states;
}

}  // namespace lubjoint::verify
