// The inner loop takes no memory.
#include <Eigen/Core>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <vector>

#include "leave_out/counted_memory.hpp"
#include "lubjoint/film/law_list.hpp"
#include "lubjoint/motion/film_modes.hpp"
#include "lubjoint/ode/exact_jacobian.hpp"
#include "lubjoint/ode/radau_iia.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "support/compiled_films.hpp"

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

const std::string scenes = LUBJOINT_SOURCE_DIR "/data/scenes/";

/// Allocations that a piece of code makes.
template <class F>
std::size_t allocations_of(const F& f) {
  const std::size_t before = allocations();
  f();
  return allocations() - before;
}

using T = Dual<double, 4>;

/// The scenes' systems: with and without constraints, a film, a contact, the ledger.
struct Case {
  std::string file;
  bool ledger;
};
std::vector<Case> cases() {
  return {{"slider-crank.toml", false},
          {"slider-crank.toml", true},
          {"slider-crank-ideal.toml", true},
          {"slider-crank-torque.toml", false},
          {"impact.toml", true}};
}

/// A scene's equations at its start, journals off centre and moving.
struct Equations {
  explicit Equations(const Case& each)
      : scene(load_scene(scenes + each.file)),
        system(planar_system<double>(scene)),
        ode(system, each.ledger),
        y(scene_start<double>(scene)) {
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += 1e-5 * std::sin(3.0 * static_cast<double>(i + 1));
    y.resize(ode.dimension());
    rate = y;
  }

  Scene scene;
  PlanarSystem<double> system;
  MultibodyOde<double> ode;
  std::vector<double> y;
  std::vector<double> rate;
  Eigen::MatrixXd jacobian;
};

}  // namespace

TEST_CASE("the counter counts: vectors, aligned objects, Eigen's matrices, malloc") {
  // Seen from outside, so that the compiler can't do without it.
  const auto seen = [](const void* place) { asm volatile("" : : "r"(place) : "memory"); };
  struct alignas(64) Wide {
    double numbers[8];
  };
  CHECK(allocations_of([&] { seen(std::vector<double>(100).data()); }) == 1);
  CHECK(allocations_of([&] { seen(std::make_unique<Wide>().get()); }) == 1);
  CHECK(allocations_of([&] { seen(Eigen::MatrixXd(Eigen::MatrixXd::Zero(9, 9)).data()); }) == 1);
  CHECK(allocations_of([&] {
          void* place = std::malloc(10);
          seen(place);
          std::free(place);
        }) == 1);
}

TEST_CASE("no film law allocates, on numbers or with derivatives") {
  const Bearing<double> bearing(0.04, 0.0098, 2e-4);
  const Lubricant<double> oil(0.4);
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    double sum = 0;
    const std::size_t taken = allocations_of([&] {
      for (const double epsilon : {0.0, 1e-300, 0.3, 0.99, 1 - 1e-12}) {
        for (const double speed : {0.0, 1e-300, -2.0, 5.0}) {
          const FilmState<double> film(Vector2<double>(epsilon, 0), Vector2<double>(speed, 0.5 * speed));
          sum += film_force<Law>(bearing, oil, film).x();
          const FilmState<T> dual(Vector2<T>(T::variable(epsilon, 0), T::variable(0, 1)),
                                  Vector2<T>(T::variable(speed, 2), T::variable(0.5 * speed, 3)));
          sum += film_force<Law>(bearing, oil, dual).x().value();
        }
      }
    });
    CHECK(taken == 0);
    CHECK(std::isfinite(sum));
  });
}

TEST_CASE("no compiled law allocates, on numbers or with derivatives, also where a joint holds it") {
  const Bearing<double> bearing(0.04, 0.0098, 2e-4);
  const Lubricant<double> oil(0.4);
  for (const std::string_view law : names_of_laws<CompiledLaws>) {
    INFO(law);
    const AnyFilm<double> joint = make_film(law, bearing, oil, shipped_film(law, shipped_scenes_shape).get());
    double sum = 0;
    const std::size_t taken = allocations_of([&] {
      for (const double epsilon : {0.0, 1e-300, 0.3, 0.99, 1 - 1e-12}) {
        for (const double speed : {0.0, 1e-300, -2.0, 5.0}) {
          const FilmState<double> film(Vector2<double>(epsilon, 0), Vector2<double>(speed, 0.5 * speed));
          const FilmState<T> dual(Vector2<T>(T::variable(epsilon, 0), T::variable(0, 1)),
                                  Vector2<T>(T::variable(speed, 2), T::variable(0.5 * speed, 3)));
          sum +=
              std::visit([&](const auto& each) { return each.force(film).x() + each.force(dual).y().value(); }, joint);
        }
      }
    });
    CHECK(taken == 0);
    CHECK(std::isfinite(sum));
  }
}

TEST_CASE("a free journal's Radau steps allocate nothing after the first") {
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    const FreeJournal<Law> journal(
        LubricatedJoint<Law, double>(Bearing<double>(0.04, 0.0098, 2e-4), Lubricant<double>(0.4)),
        {0.13, Vector2<double>(0, -31.2753), 0, 52.36});
    using State = std::array<double, 4>;
    const auto rate = [&](const State& y, State& dydt, double) { journal.rate(y, dydt); };
    const auto jacobian = [&](const State& y, auto& j, double) {
      exact_jacobian([&](const auto& x, auto& dxdt) { journal.rate(x, dxdt); }, y, j);
    };
    RadauIIA5<double, 4> stepper(1e-6, {1e-6, 1e-6, 1e-4, 1e-4});
    State y{0.1, 0.0, 0.0, -1.0};
    double t = 0;
    double dt = 1e-5;
    const auto system = std::make_pair(rate, jacobian);
    stepper.try_step(system, y, t, dt);
    CHECK(allocations_of([&] {
            for (int i = 0; i < 20; ++i) stepper.try_step(system, y, t, dt);
            State inside;
            stepper.state_at(t, inside);
          }) == 0);
    CHECK(t > 0);
  });
}

TEST_CASE("a multibody right-hand side allocates nothing after the first") {
  for (const Case& each : cases()) {
    INFO(each.file);
    Equations e(each);
    e.ode.rate(e.y, e.rate, 0.0);
    CHECK(allocations_of([&] {
            for (int i = 0; i < 10; ++i) e.ode.rate(e.y, e.rate, 1e-5 * i);
          }) == 0);
  }
}

TEST_CASE("an evaluation with derivatives takes no memory beyond its workspace") {
  using T = MultibodyOde<double>::Seeded;
  for (const Case& each : cases()) {
    INFO(each.file);
    const Equations e(each);
    SystemWorkspace<T> w = e.system.workspace<T>();
    std::vector<T> y(e.y.begin(), e.y.end());
    for (std::size_t j = 0; j < 6; ++j) y[j] = T::variable(e.y[j], static_cast<Eigen::Index>(j));
    CHECK(allocations_of([&] {
            for (int i = 0; i < 10; ++i) e.system.evaluate(1e-5 * i, y.data(), {}, w);
          }) == 0);
  }
}

TEST_CASE("a multibody system's exact Jacobian allocates nothing after the first") {
  for (const Case& each : cases()) {
    INFO(each.file);
    Equations e(each);
    e.ode.jacobian(e.y, e.jacobian, 0.0);
    CHECK(allocations_of([&] {
            for (int i = 0; i < 10; ++i) e.ode.jacobian(e.y, e.jacobian, 1e-5 * i);
          }) == 0);
  }
}

TEST_CASE("a multibody system's Radau steps allocate nothing after the first few") {
  for (const Case& each : cases()) {
    INFO(each.file);
    Equations e(each);
    RadauIIA5<double, run_time_size> stepper(1e-6, std::vector<double>(e.y.size(), 1e-6));
    const auto rate = [&](const auto& y, auto& dydt, double t) { e.ode.rate(y, dydt, t); };
    const auto jacobian = [&](const auto& y, auto& j, double t) { e.ode.jacobian(y, j, t); };
    const auto system = std::make_pair(rate, jacobian);
    double t = 0;
    double dt = 1e-7;
    for (int i = 0; i < 3; ++i) stepper.try_step(system, e.y, t, dt);
    CHECK(allocations_of([&] {
            for (int i = 0; i < 20; ++i) stepper.try_step(system, e.y, t, dt);
          }) == 0);
    CHECK(t > 0);
  }
}
