#include "oracle/trajectories/second_derivation.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <stdexcept>

#include "lubjoint/film/every_law.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/mechanisms/free_journal.hpp"
#include "oracle/mechanisms/slider_crank_loop.hpp"
#include "oracle/trajectories/free_journal_scene.hpp"
#include "oracle/trajectories/slider_crank_reference.hpp"
#include "oracle/trajectories/slider_crank_scene.hpp"

namespace lubjoint::reports {

namespace {

using R = long double;
using Values = TrajectoryValues<double>;

/// The smaller tolerance of the two runs; rounding to 64 bits leaves as much.
constexpr double tolerance = 1e-13;

// The journal.

Values journal_rows(const Scene& scene, const std::string& law, const std::vector<double>& times, double step_error) {
  const mechanisms::FreeJournalCase<R> journal = free_journal_case<R>(scene);
  const bool velocities = is_free_journal(scene);
  const std::vector<R> at(times.begin(), times.end());
  const auto run = with_film_law<StateFilmLaws>(law, [&]<class Law>() {
    return mechanisms::free_journal_run<typename mechanisms::JournalFilmOf<Law>::Type, R>(journal, at, R(step_error));
  });
  if (!run.stopped.empty()) throw std::runtime_error("second derivation: " + run.stopped);
  Values rows;
  for (const auto& sample : run.samples) {
    std::vector<R> row(sample.eccentricity.begin(), sample.eccentricity.end());
    if (velocities) row.insert(row.end(), sample.velocity.begin(), sample.velocity.end());
    row.insert(row.end(), sample.force.begin(), sample.force.end());
    rows.emplace_back(row.begin(), row.end());
  }
  return rows;
}

// The slider-crank with a film.

/// The mechanism in minimal coordinates as the integrator takes it.
struct MinimalSystem {
  mechanisms::LubricatedSliderCrank<PinkusSternlicht, R> mechanism;

  static constexpr std::size_t states() { return 4; }
  void rate(const R& t, const mechanisms::ShortState<R, 4>& y, mechanisms::ShortState<R, 4>& dydt) const {
    mechanism.rate(y, dydt, t);
  }
  /// All components are of the order of one. A film of a thousandth of the clearance is the thinnest there is.
  static void weights(const mechanisms::ShortState<R, 4>&, mechanisms::ShortState<R, 4>& w) {
    w = {R(1e-2), R(1e-2), R(1), R(1)};
  }
  static void increments(const mechanisms::ShortState<R, 4>&, mechanisms::ShortState<R, 4>& d) { d.fill(R(1e-11)); }
};

/// The scene's start in these coordinates. Its doubles miss the crank pin's constraint by their rounding, some 1e-13 of
/// a clearance: as for the other methods, the start is the nearest in the norm of the kinetic energy that fulfils it.
/// The driven crank is where it must be; extended, the rod's angle and the slider's place are free; with h = l/2 the
/// rod's v_y − hω must be Ωr, which moves ω by (h/J)(v_y − hω − Ωr)/(1/m + h²/J).
/// @throws std::invalid_argument if the scene does not start extended
mechanisms::ShortState<R, 4> minimal_start(const Scene& scene) {
  for (const SceneBody& body : scene.bodies) {
    if (body.angle == 0 && body.position.y() == 0) continue;
    throw std::invalid_argument(scene.file + ": body \"" + body.name + "\" must start on the line of the guide");
  }
  const auto m = mechanism_of<R>(scene);
  const R speed(crank_speed_of(scene));
  const R c(scene.joints.at(0).clearance);
  const auto ideal = mechanisms::ideal_motion<R>(m, {R(0), speed, R(0)});
  const SceneBody& rod = body_of(scene, "rod");
  const SceneBody& slider = body_of(scene, "slider");
  const R h = m.rod_length / 2;
  const R miss = R(rod.velocity.y()) - h * R(rod.spin) - speed * m.crank_length;
  const R spin = R(rod.spin) + h / m.rod_inertia * miss / (1 / m.rod_mass + h * h / m.rod_inertia);
  return {R(0), (R(slider.position.x()) - ideal.slider.value) / c, m.rod_length * (spin - ideal.rod.rate) / (c * speed),
          (R(slider.velocity.x()) - ideal.slider.rate) / (c * speed)};
}

Values minimal_rows(const Scene& scene, const std::vector<double>& times, double step_error) {
  const MinimalSystem system{lubricated_slider_crank<PinkusSternlicht, R>(scene)};
  mechanisms::Lobatto<R, 4> method{R(step_error)};
  mechanisms::ShortState<R, 4> y = minimal_start(scene);
  R t = 0;
  Values rows;
  for (const double time : times) {
    method.reach(system, t, y, R(time));
    t = R(time);
    const auto pin = system.mechanism.pin(t, y);
    const std::vector<R> row = {pin.eccentricity.x(), pin.eccentricity.y(), pin.force.x(), pin.force.y(),
                                system.mechanism.driving_moment(t, y)};
    rows.emplace_back(row.begin(), row.end());
  }
  return rows;
}

// The ideal slider-crank.

/// Places and angles of all bodies with the crank at θ.
std::vector<R> ideal_row(const Scene& scene, const mechanisms::SliderCrank<R>& m, const R& theta) {
  const mechanisms::SliderCrankLoop<R> loop(m, theta);
  std::vector<R> row;
  for (const SceneBody& body : scene.bodies) {
    if (body.name == "crank") row.insert(row.end(), {loop.crank_pin[0].value / 2, loop.crank_pin[1].value / 2});
    if (body.name == "rod") row.insert(row.end(), {loop.rod[0].value, loop.rod[1].value});
    if (body.name == "slider") row.insert(row.end(), {loop.slider.value, R(0)});
  }
  for (const SceneBody& body : scene.bodies) {
    row.push_back(body.name == "crank" ? theta : body.name == "rod" ? loop.rod_angle.value : R(0));
  }
  return row;
}

bool is_driven(const Scene& scene) {
  return std::any_of(scene.constraints.begin(), scene.constraints.end(),
                     [](const SceneConstraint& c) { return std::holds_alternative<Driver<double>>(c.constraint); });
}

Values driven_rows(const Scene& scene, const std::vector<double>& times) {
  const auto m = mechanism_of<R>(scene);
  const R speed(crank_speed_of(scene));
  Values rows;
  for (const double t : times) {
    const R theta = speed * R(t);
    std::vector<R> row = ideal_row(scene, m, theta);
    row.push_back(mechanisms::SliderCrankLoop<R>(m, theta).driving_moment(m, speed));
    rows.emplace_back(row.begin(), row.end());
  }
  return rows;
}

/// The only load is a moment on the crank, and nothing moves at the start.
bool is_torque_driven(const Scene& scene) {
  if (!scene.joints.empty() || is_driven(scene) || scene.loads.size() != 1 || !is_zero(scene.gravity)) return false;
  const SceneLoad& load = scene.loads[0];
  const bool rests = std::all_of(scene.bodies.begin(), scene.bodies.end(), [](const SceneBody& body) {
    return is_zero(body.velocity) && body.spin == 0 && body.angle == 0;
  });
  return rests && scene.bodies[load.body].name == "crank" && load.moment > 0 && is_zero(load.force);
}

Values torque_rows(const Scene& scene, const std::vector<double>& times) {
  const auto m = mechanism_of<R>(scene);
  const R moment(scene.loads[0].moment);
  const auto integrate = [](const auto& f, const R& a, const R& b) {
    return boost::math::quadrature::gauss_kronrod<R, 61>::integrate(f, a, b, 12, 1e-17L);
  };
  Values rows;
  R theta = 0;
  R before = 0;
  for (const double t : times) {
    // Newton on the time at which the crank is at θ; dθ/dt comes from the energy.
    theta = theta > 0 ? R(theta + mechanisms::torque_driven_speed(m, moment, theta) * (R(t) - before))
                      : R(moment * R(t) * R(t) / (2 * mechanisms::effective_inertia(m, R(0))));
    for (int i = 0; i < 20; ++i) {
      const R late = mechanisms::torque_driven_time(m, moment, theta, integrate) - R(t);
      const R change = -late * mechanisms::torque_driven_speed(m, moment, theta);
      theta += change;
      if (std::abs(change) <= 4 * std::numeric_limits<R>::epsilon() * theta) break;
    }
    before = R(t);
    const std::vector<R> row = ideal_row(scene, m, theta);
    rows.emplace_back(row.begin(), row.end());
  }
  return rows;
}

bool is_slider_crank(const Scene& scene) {
  try {
    mechanism_of<R>(scene);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

/// With what ten times the tolerance changes.
template <class RowsAt>
SecondDerivation twice(const std::string& how, const TrajectoryColumns& columns, const RowsAt& rows_at) {
  SecondDerivation result{how, columns, rows_at(tolerance), {}};
  result.own_error = disagreements(result.rows, rows_at(10 * tolerance), columns.vectors);
  return result;
}

TrajectoryColumns columns_of(const Scene& scene) {
  return is_free_journal(scene) ? journal_columns() : multibody_columns(scene);
}

}  // namespace

SecondDerivation second_derivation(const Scene& scene, const std::string& law, const std::vector<double>& times) {
  const TrajectoryColumns columns = columns_of(scene);
  if (is_lone_journal(scene)) {
    const std::string& film = law.empty() ? scene.joints[0].film : law;
    return twice("turning frame, Lobatto IIIC", columns,
                 [&](double error) { return journal_rows(scene, film, times, error); });
  }
  if (is_slider_crank(scene) && has_minimal_coordinates(scene)) {
    return twice("rod angle and slider position, Lobatto IIIC", columns,
                 [&](double error) { return minimal_rows(scene, times, error); });
  }
  const std::vector<double> exact(times.size(), 0.0);
  if (is_slider_crank(scene) && scene.joints.empty() && is_driven(scene)) {
    return {"loop, moment from the energy", columns, driven_rows(scene, times), exact};
  }
  if (is_slider_crank(scene) && is_torque_driven(scene)) {
    return {"energy integral", columns, torque_rows(scene, times), exact};
  }
  throw std::invalid_argument(scene.file + " has no second derivation; allowed are a journal in a bearing on the " +
                              "ground and slider-cranks that start extended");
}

std::size_t SecondAgreement::first_wrong() const {
  std::size_t row = 0;
  while (row < apart.size() && agrees(row)) ++row;
  return row;
}

SecondAgreement second_agreement(const SecondDerivation& second, const CsvTable& file) {
  const std::size_t stated = file.column("disagreement");
  std::vector<std::size_t> places;
  for (const std::string& name : second.columns.names) places.push_back(file.column(name));
  if (file.columns().size() != places.size() + 2 || file.rows() != second.rows.size()) {
    throw CsvError("the trajectory has other columns or rows than its second derivation");
  }
  Values stored;
  for (std::size_t row = 0; row < file.rows(); ++row) {
    stored.emplace_back();
    for (const std::size_t place : places) stored.back().push_back(file.number(row, place));
  }
  SecondAgreement result{second.how, disagreements(second.rows, stored, second.columns.vectors), {}};
  constexpr double printed = 1e-15;  // half a unit of the 16th digit, of up to three components
  double so_far = 0;
  for (std::size_t row = 0; row < stored.size(); ++row) {
    so_far = std::max(so_far, file.number(row, stated));
    // The file's figure is rounded to one digit, by half of it at most. What a power of ten in the tolerance changes
    // is larger than the error where that falls with the tolerance, and of its size where rounding is left.
    result.allowed.push_back(1.5 * so_far + 3 * second.own_error[row] + printed);
  }
  result.digits = agreed_digits(result.apart);
  return result;
}

SecondAgreement second_agreement(const Scene& scene, const std::string& law, const CsvTable& file) {
  const std::size_t t = file.column("t");
  std::vector<double> times;
  for (std::size_t row = 0; row < file.rows(); ++row) times.push_back(file.number(row, t));
  return second_agreement(second_derivation(scene, law, times), file);
}

}  // namespace lubjoint::reports
