#include "oracle/laws/film_compiler.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/text/message.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/reynolds/cavitated_film.hpp"
#include "oracle/reynolds/circumferential_modes.hpp"
#include "oracle/reynolds/smooth_film.hpp"

namespace lubjoint::reports {

namespace {

using oracle::ScaledFilm;
using oracle::ScaledForce;

constexpr double pi = std::numbers::pi;

/// A motion as the solvers see it, scaled to |u| = 1.
struct State {
  double epsilon;
  double q;       ///< 1 − ε²
  double cosine;  ///< u·r
  double sine;    ///< −u·t ≥ 0: the angle from u to e, counter-clockwise

  ScaledFilm scaled(double shape) const { return {epsilon, q / (1 + epsilon), 2 * sine, cosine, shape}; }
};

/// F/S with S = μLR³/c²: p = 6μ(R/c)² P over an area of R² dθ dζ, and R/L = 1/(2Λ).
Eigen::Vector2d in_units_of_scale(const ScaledForce& force, double shape) { return 3 / shape * force.value; }

/// ρ_k: the Chebyshev points of a count, cos(π(k+½)/n).
double chebyshev_point(int k, int count) { return std::cos(pi * (k + 0.5) / count); }

/// Coefficients of the series through values at the Chebyshev points: of one variable where columns is 1.
/// @param values  (k, l) at the k-th point of the first and the l-th of the second variable
Eigen::MatrixXd series_through(const Eigen::MatrixXd& values) {
  const auto transform = [](Eigen::Index count) {
    Eigen::MatrixXd t(count, count);
    for (Eigen::Index k = 0; k < count; ++k) {
      for (Eigen::Index i = 0; i < count; ++i) {
        const double angle = pi * static_cast<double>(k) * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        t(k, i) = (k == 0 ? 1 : 2) * std::cos(angle) / static_cast<double>(count);
      }
    }
    return t;
  };
  return transform(values.rows()) * values * transform(values.cols()).transpose();
}

void append(CompiledFilm& film, const Eigen::MatrixXd& series) {
  film.coefficients.insert(film.coefficients.end(), series.data(), series.data() + series.size());
}

/// Pieces of work that report their progress.
class Work {
 public:
  Work(const CompilerOptions& options, std::size_t all) : options_(options), all_(all) {}

  template <class Piece>
  void run(std::size_t count, const Piece& piece) {
    run_parallel(count, options_.threads, [&](std::size_t i) {
      piece(i);
      const std::lock_guard lock(mutex_);
      ++done_;
      if (options_.progress) options_.progress(done_, all_);
    });
  }

 private:
  const CompilerOptions& options_;
  std::size_t all_;
  std::size_t done_ = 0;
  std::mutex mutex_;
};

/// Error asked of the solver where a table is read; below what the series reach.
constexpr double smooth_tolerance = 1e-10;
constexpr double smooth_check_tolerance = 1e-8;
/// W∥ is right to a tenth of the grids' estimate, which is that of both components.
constexpr double cavitated_tolerance = 1e-4;
constexpr double cavitated_check_tolerance = 2e-5;

/// Where a table is held against the solver.
struct TableCheck {
  int states;
  double ratio_limit;
};
/// Of the statement over the worst state seen: among 10,000 states the worst was up to 3.8 times that.
constexpr double safety = 5;
constexpr TableCheck smooth_check{100, 0.99};
constexpr TableCheck cavitated_check{48, 0.95};

Eigen::Vector2d wedge_or_squeeze(FilmExtent extent, double v, bool wedge, double shape) {
  const double q = v * v * v * v;
  const double epsilon = std::sqrt((1 - v) * (1 + v) * (1 + v * v));
  const ScaledFilm film{epsilon, q / (1 + epsilon), wedge ? 1.0 : 0.0, wedge ? 0.0 : 1.0, shape};
  return in_units_of_scale(oracle::circumferential_film_force(extent, film, smooth_tolerance), shape);
}

/// The series of the laws that are linear in a and b: functions of v = (1−ε²)^¼.
/// @param ratios  of the forces of a = 1 and of b = 1 at an ε, over the law's means
template <class Law, class Ratios>
void compile_curves(CompiledFilm& film, Work& work, FilmExtent extent, const Ratios& ratios) {
  constexpr int columns = static_cast<int>(Law::coefficients) / Law::terms;
  Eigen::MatrixXd values(Law::terms, columns);
  work.run(Law::terms, [&](std::size_t k) {
    const double at = chebyshev_point(static_cast<int>(k), Law::terms);
    const double v = Law::lowest + (1 - Law::lowest) * (1 + at) / 2;
    values.row(static_cast<Eigen::Index>(k)) =
        ratios(v, wedge_or_squeeze(extent, v, true, film.shape), wedge_or_squeeze(extent, v, false, film.shape));
  });
  for (int column = 0; column < columns; ++column) append(film, series_through(values.col(column)));
}

void compile_full(CompiledFilm& film, Work& work) {
  compile_curves<FiniteFull>(film, work, FilmExtent::full,
                             [&](double v, const Eigen::Vector2d& wedge, const Eigen::Vector2d& squeeze) {
                               const double q = v * v * v * v;
                               const double a = 2 * wedge[1];  // F_t = A a/2, F_r = −(A + Bε²) b
                               const double b = (-squeeze[0] - a) / ((1 - v) * (1 + v) * (1 + v * v));
                               return Eigen::RowVector2d(a / FiniteFull::isotropic(q, film.shape),
                                                         b / FiniteFull::along_eccentricity(q, film.shape));
                             });
}

void compile_half(CompiledFilm& film, Work& work) {
  compile_curves<FiniteHalf>(
      film, work, FilmExtent::half, [&](double v, const Eigen::Vector2d& wedge, const Eigen::Vector2d& squeeze) {
        const double q = v * v * v * v;
        const FiniteHalf::Means<double> mean(q, film.shape);
        const double epsilon = std::sqrt((1 - v) * (1 + v) * (1 + v * v));
        return Eigen::RowVector3d(-wedge[0] / (epsilon * mean.alpha), -squeeze[0] / mean.beta, wedge[1] / mean.tau);
      });
}

/// A state at a place of the two-variable tables, and the law's coordinates there.
struct TablePlace {
  State state;
  lubjoint::detail::FilmPlace<double> place;

  TablePlace(double t, double r) : state(state_at(t, r)), place(x(state), y(state), state.q) {}

  static double x(const State& s) { return s.epsilon * s.cosine; }
  static double y(const State& s) { return s.epsilon * s.sine; }

  static State state_at(double t, double r) {
    const double s = (1 - t) * (1 + t);  // √(sinδ)
    const double sine = s * s;
    const double n = r * r;
    const double along = n * std::copysign(std::sqrt((1 - sine) * (1 + sine)), t);
    const double across = std::sqrt((1 - n) * (1 + n));
    const double epsilon = std::hypot(along, across);
    return {epsilon, n * n * sine * sine, along / epsilon, across / epsilon};
  }

  /// Components along û and û⊥ of a force in r and t.
  Eigen::Vector2d seen_from_motion(const Eigen::Vector2d& polar) const {
    return {polar[0] * state.cosine - polar[1] * state.sine, polar[0] * state.sine + polar[1] * state.cosine};
  }
};

template <class Law, class Read>
void compile_surface(CompiledFilm& film, Work& work, const Read& read) {
  constexpr int series = static_cast<int>(Law::coefficients) / (Law::around * Law::outward);
  std::vector<Eigen::MatrixXd> values(series, Eigen::MatrixXd(Law::around, Law::outward));
  work.run(Law::around * Law::outward, [&](std::size_t piece) {
    const int k = static_cast<int>(piece) / Law::outward;
    const int l = static_cast<int>(piece) % Law::outward;
    const double t = Law::reach * chebyshev_point(k, Law::around);
    const double r = Law::lowest + (1 - Law::lowest) * (1 + chebyshev_point(l, Law::outward)) / 2;
    const auto read_values = read(TablePlace(t, r));
    for (int i = 0; i < series; ++i) values[static_cast<std::size_t>(i)](k, l) = read_values[i];
  });
  for (const Eigen::MatrixXd& each : values) append(film, series_through(each));
}

void compile_dynamic(CompiledFilm& film, Work& work) {
  compile_surface<FiniteDynamic>(film, work, [&](const TablePlace& at) {
    const ScaledFilm scaled = at.state.scaled(film.shape);
    const ScaledForce force = oracle::circumferential_film_force(FilmExtent::dynamic, scaled, smooth_tolerance);
    const Eigen::Vector2d ratio =
        at.seen_from_motion(in_units_of_scale(force, film.shape)) / -at.place.size(film.shape);
    return Eigen::Vector2d(ratio[0], ratio[1] * at.place.n / at.place.y);
  });
}

void compile_reynolds(CompiledFilm& film, Work& work) {
  compile_surface<FiniteReynolds>(film, work, [&](const TablePlace& at) {
    const ScaledForce force = oracle::cavitated_film_force(at.state.scaled(film.shape), false, cavitated_tolerance);
    const Eigen::Vector2d ratio =
        at.seen_from_motion(in_units_of_scale(force, film.shape)) / -at.place.size(film.shape);
    return Eigen::Matrix<double, 1, 1>(std::log(ratio[0]));
  });
}

/// Solver of another family, or finer, than the one the table is made with.
template <class Law>
ScaledForce check_solution(const ScaledFilm& state) {
  if constexpr (std::is_same_v<Law, FiniteReynolds>) {
    return oracle::cavitated_film_force(state, false, cavitated_check_tolerance);
  } else {
    return oracle::smooth_film_force(Law::extent, state, smooth_check_tolerance);
  }
}

template <class Law>
void state_error(CompiledFilm& film, Work& work, const TableCheck& check) {
  film.ratio_limit = check.ratio_limit;
  const Law law(film);
  std::mt19937_64 random(20240607);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<State> states;
  for (int n = 0; n < check.states; ++n) {
    const double epsilon = check.ratio_limit * uniform();
    const double angle = pi * uniform();
    states.push_back({epsilon, (1 - epsilon) * (1 + epsilon), std::cos(angle), std::sin(angle)});
  }
  std::vector<double> differences(states.size());
  work.run(states.size(), [&](std::size_t n) {
    const State& state = states[n];
    const ScaledForce solved = check_solution<Law>(state.scaled(film.shape));
    const Eigen::Vector2d force = in_units_of_scale(solved, film.shape);
    const PolarFilmState<double> polar(state.epsilon, 2 * state.sine, state.cosine, state.q);
    const Vector2<double> compiled = compiled_force_ratio(law, polar.in_own_frame());
    // The solver's own error is not seen by the comparison.
    differences[n] = (safety * (compiled - force).norm() + 3 / film.shape * solved.error.norm()) / force.norm();
  });
  for (const double each : differences) {
    if (!std::isfinite(each)) throw std::runtime_error("the error of " + film.film + " is not finite");
  }
  film.error = *std::max_element(differences.begin(), differences.end());
}

}  // namespace

CompiledFilm compile_film(std::string_view name, double shape, const CompilerOptions& options) {
  if (!(shape >= least_compiled_shape && shape <= largest_compiled_shape)) {
    Message message;
    message << "length over diameter is " << shape << "; films of finite length are compiled for "
            << least_compiled_shape << " to " << largest_compiled_shape;
    throw std::invalid_argument(message.str());
  }
  CompiledFilm film;
  film.film = name;
  film.shape = shape;
  const auto compile = [&]<class Law>(std::size_t places, const TableCheck& check, auto make) {
    Work work(options, places + static_cast<std::size_t>(check.states));
    make(film, work);
    state_error<Law>(film, work, check);
    return film;
  };
  if (name == FiniteFull::name) return compile.operator()<FiniteFull>(FiniteFull::terms, smooth_check, compile_full);
  if (name == FiniteHalf::name) return compile.operator()<FiniteHalf>(FiniteHalf::terms, smooth_check, compile_half);
  if (name == FiniteDynamic::name) {
    return compile.operator()<FiniteDynamic>(FiniteDynamic::around * FiniteDynamic::outward, smooth_check,
                                             compile_dynamic);
  }
  if (name == FiniteReynolds::name) {
    return compile.operator()<FiniteReynolds>(FiniteReynolds::around * FiniteReynolds::outward, cavitated_check,
                                              compile_reynolds);
  }
  throw std::invalid_argument("there is no compiled law \"" + std::string(name) + "\"; allowed are " +
                              listed_film_laws<CompiledLaws>());
}

}  // namespace lubjoint::reports
