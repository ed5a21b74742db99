#include "lubjoint/multibody/massless_journal.hpp"

#include <boost/numeric/odeint.hpp>

#include "lubjoint/film/steady_place.hpp"
#include "support/journal_cases.hpp"

namespace massless_journal_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

using Start = MasslessState<double>;

/// The bearing and load of Table 1.
template <FilmLaw Law>
MasslessJournal<Law> massless() {
  const FreeJournal<Law> journal = journal_of_table_1<Law>();
  return {journal.joint(), journal.drive()};
}

/// ê at `duration`, by Odeint's Dormand–Prince with a tolerance of 1e-12.
template <FilmLaw Law>
Start end_of_motion(const MasslessJournal<Law>& journal, Start y, double duration) {
  namespace odeint = boost::numeric::odeint;
  const auto stepper = odeint::make_controlled<odeint::runge_kutta_dopri5<Start>>(1e-12, 1e-12);
  odeint::integrate_adaptive(
      stepper, [&](const Start& x, Start& dxdt, double) { journal.rate(x, dxdt); }, y, 0.0, duration, duration / 1000);
  return y;
}

template <class Check>
void for_each_law(const Check& check) {
  check.template operator()<ShortFull>();
  check.template operator()<ShortDynamic>();
  check.template operator()<LongFull>();
  check.template operator()<LongDynamic>();
  check.template operator()<PinkusSternlicht>();
}

}  // namespace

TEST_CASE("massless journal: its film carries the load at every place, and its Jacobian is that of differences") {
  for_each_law([]<class Law>() {
    INFO(Law::name);
    const MasslessJournal<Law> journal = massless<Law>();
    for (const Start& y : {Start{0.1, 0.2}, Start{-0.5, 0.3}, Start{0.0, -0.8}}) {
      const FilmState<double> film({y[0], y[1]}, journal.velocity(y));
      const Vector2<double> force = journal.joint().force(film);
      CHECK((force + journal.drive().load).norm() <= 1e-13 * force.norm());  // rounding times the condition, 6/q
      const auto exact = journal.jacobian(y);
      for (int i = 0; i < 2; ++i) {
        const double h = 1e-6;
        Start up = y, down = y, above{}, below{};
        up[static_cast<std::size_t>(i)] += h;
        down[static_cast<std::size_t>(i)] -= h;
        journal.rate(up, above);
        journal.rate(down, below);
        for (int k = 0; k < 2; ++k) {
          const auto j = static_cast<std::size_t>(k);
          const double difference = (above[j] - below[j]) / (2 * h);
          CHECK(std::abs(difference - exact(k, i)) <= 1e-7 * exact.norm());  // h², and rounding over h
        }
      }
    }
  });
}

TEST_CASE("massless journal: from the centre it comes to rest where the film carries the load") {
  const auto rests = []<FilmLaw Law>() {
    INFO(Law::name);
    const MasslessJournal<Law> journal = massless<Law>();
    const Start end = end_of_motion(journal, {0, 0}, 3);
    const double load = journal.drive().load.norm();
    const double spins = journal.drive().journal_spin + journal.drive().bearing_spin;
    const auto place = steady_place<Law>(load / (journal.joint().force_scale() * spins));
    REQUIRE(place);
    CHECK(std::hypot(end[0], end[1]) == Approx(place->eccentricity_ratio).epsilon(1e-5));  // three seconds
    Start rest = end;
    for (int i = 0; i < 5; ++i) {  // Newton
      Start rate{};
      journal.rate(rest, rate);
      const Vector2<double> step = journal.jacobian(rest).inverse() * Vector2<double>(rate[0], rate[1]);
      rest = {rest[0] - step.x(), rest[1] - step.y()};
    }
    CHECK(std::hypot(rest[0], rest[1]) == Approx(place->eccentricity_ratio).epsilon(1e-13));  // rounding
  };
  rests.operator()<ShortDynamic>();
  rests.operator()<LongDynamic>();
  rests.operator()<PinkusSternlicht>();
}

TEST_CASE("a light journal follows the massless one to first order in its mass") {
  for_each_law([]<class Law>() {
    const FreeJournal<Law> heavy = journal_of_table_1<Law>();
    const MasslessJournal<Law> limit = massless<Law>();
    const Start start{0.1, -0.05};
    const double duration = 0.02;
    const Start end = end_of_motion(limit, start, duration);
    Start rate{};
    limit.rate(start, rate);
    std::vector<double> apart;
    for (const double mass : {2e-3, 1e-3, 5e-4}) {
      JournalDrive<double> drive = heavy.drive();
      drive.mass = mass;
      const FreeJournal<Law> light(heavy.joint(), drive);
      JournalRun<Law> run(light, "bearing", "radau_iia5",
                          {.duration = duration, .relative_tolerance = 1e-11, .absolute_tolerance = 1e-11});
      REQUIRE(run.run({start[0], start[1], rate[0], rate[1]}).status == RunStatus::finished);
      const auto& y = run.recorder().samples().back().state;
      apart.push_back(std::hypot(y[0] - end[0], y[1] - end[1]));
    }
    const double first = std::log2(apart[0] / apart[1]);
    const double second = std::log2(apart[1] / apart[2]);
    INFO(Law::name << ": " << apart[0] << ", " << apart[1] << ", " << apart[2] << ": orders " << first << ", "
                   << second);
    CHECK(second == Approx(1).margin(0.05));                   // first order; the next term falls with the mass
    CHECK(std::abs(second - 1) < std::abs(first - 1) + 1e-3);  // and nearer with every halving
    CHECK(apart[2] > 1e-9);                                    // above what the steps are good to
  });
}

}  // namespace massless_journal_test
