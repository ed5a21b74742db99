#include "oracle/verify/states/film_places.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace lubjoint::verify {

namespace {

using Real = long double;
using Rule = boost::math::quadrature::gauss<Real, 20>;
constexpr Real pi = boost::math::constants::pi<Real>();

class Panels {
 public:
  Panels(Real ratio, Real gap) : ratio_(ratio), gap_(gap) {}

  /// Angles from the minimum film.
  void add(Real from, Real to) {
    if (!(to > from)) return;
    const Real middle = (from + to) / 4, half = (to - from) / 4;  // of φ/2
    const Real sine_m = std::sin(middle), cosine_m = std::cos(middle);
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      const Real x = half * Rule::abscissa()[i], sine_x = std::sin(x), cosine_x = std::cos(x);
      for (const Real side : {-sine_x, sine_x}) {
        const Real sine = sine_m * cosine_x + cosine_m * side, cosine = cosine_m * cosine_x - sine_m * side;
        const Real wall = 2 * sine * sine;  // 1 − cosφ
        places_.push_back({2 * half * Rule::weights()[i], -2 * sine * cosine, wall - 1, wall, gap_ + ratio_ * wall});
      }
    }
  }

  /// A stretch between a minimum and a maximum film, by its distance from the minimum film; on one side of it.
  void add_graded(Real near, Real far, bool after) {
    const Real shortest = std::sqrt(gap_) / 2;
    Real from = near;
    while (from < far) {
      const Real to = std::min(far, std::max(2 * from, shortest));
      after ? add(from, to) : add(-to, -from);
      from = to;
    }
  }

  std::vector<FilmPlace> take() { return std::move(places_); }

 private:
  Real ratio_, gap_;
  std::vector<FilmPlace> places_;
};

}  // namespace

Real film_thickness(Real ratio, Real gap, Real theta) {
  const Real sine = std::sin((theta - pi) / 2);
  return gap + 2 * ratio * sine * sine;
}

std::vector<FilmPlace> film_places(Real ratio, Real gap, Real begin, Real end) {
  Panels panels(ratio, gap);
  // Minimum films at θ = −π and π, maximum films at 0 and 2π: four stretches, and the part of the film in each.
  for (const Real minimum : {-pi, pi}) {
    const Real from = begin - minimum, to = end - minimum;
    if (from < 0) panels.add_graded(std::max(-to, Real(0)), std::min(-from, pi), false);
    if (to > 0) panels.add_graded(std::max(from, Real(0)), std::min(to, pi), true);
  }
  return panels.take();
}

}  // namespace lubjoint::verify
