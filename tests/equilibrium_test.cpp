// Equilibria of the journal, against what Newton and the film's force say of them.
#include "lubjoint/scene/equilibrium.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"

namespace equilibrium_test {

using namespace lubjoint;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Example 1 with a law, and with a load and no weight if one is given.
Scene journal_with(std::string_view law, std::optional<double> load = {}) {
  Scene scene = load_scene(LUBJOINT_SOURCE_DIR "/data/scenes/journal.toml");
  scene.joints.front().film = law;
  if (load) {
    scene.gravity = {0, 0};
    scene.loads.front().force = {0, -*load};
  }
  return scene;
}

/// Force on the scene's journal in long double [N].
template <class Law>
Vector2<long double> force(const Scene& scene, const JournalState<long double>& y) {
  using Long = long double;
  const JournalScene parts = journal_scene(scene);
  const Bearing<Long> bearing(parts.bearing.length(), parts.bearing.radius(), parts.bearing.clearance());
  const FreeJournal<Law, Long> journal(
      LubricatedJoint<Law, Long>(bearing, Lubricant<Long>(parts.oil.viscosity())),
      {parts.drive.mass, parts.drive.load.template cast<Long>(), parts.drive.bearing_spin, parts.drive.journal_spin});
  return journal.force(y);
}

}  // namespace

TEST_CASE("Equilibrium: the film balances the load of every law, from a micronewton to ten tons") {
  for_each_film_law([&]<class Law>() {
    for (const double load : {1e-6, 1e-3, 1.0, 31.2753, 1e3, 1e5}) {
      INFO(Law::name << " " << load << " N");
      const Scene scene = journal_with(Law::name, load);
      const JournalEquilibrium rest = journal_equilibrium(scene);
      const double ratio = rest.eccentricity_ratio;
      CHECK((ratio > 0 && ratio < 1));
      const Vector2<long double> f = force<Law>(scene, {rest.eccentricity.x(), rest.eccentricity.y(), 0, 0});
      const double tolerance = 64 * epsilon * load / (1 - ratio * ratio);  // rounding of e, F as 1/(1-e²)^(5/2) at most
      CHECK(std::abs(static_cast<double>(f.x())) < tolerance);
      CHECK(std::abs(static_cast<double>(f.y()) - load) < tolerance);
      CHECK((rest.force - Vector2<double>(0, load)).norm() < tolerance);
      CHECK(std::abs(rest.eccentricity.norm() - ratio) < 4 * epsilon);  // rounding of two components
    }
  });
}

TEST_CASE("Equilibrium: a heavier load rests at a larger eccentricity") {
  for (const std::string_view law : film_law_names) {
    double last = 0;
    for (double load = 1e-6; load < 1e6; load *= 10) {
      const double ratio = journal_equilibrium(journal_with(law, load)).eccentricity_ratio;
      INFO(law << " " << load << " N");
      CHECK(ratio > last);
      last = ratio;
    }
  }
}

TEST_CASE("Equilibrium: a light load is carried by the film's linear term, full films at right angles to it") {
  const double load = 1e-6;
  const double spin = journal_scene(journal_with("short_full", load)).drive.journal_spin;
  const double short_scale =
      force_scale(BearingLimit::short_bearing, Bearing<double>(0.04, 0.0098, 2e-4), Lubricant<double>(0.4));
  const JournalEquilibrium rest = journal_equilibrium(journal_with("short_full", load));
  const double pi = std::acos(-1.0);
  // F_t = S π a/2, a = ε ω; terms of order ε² = 1e-17 are left out.
  CHECK(std::abs(rest.eccentricity_ratio * short_scale * pi * spin / 2 / load - 1) < 64 * epsilon);  // rounding
  CHECK(std::abs(rest.attitude - pi / 2) < 4 * epsilon);                                             // rounding
}

TEST_CASE("Equilibrium: a full film's attitude is 90 degrees at any load") {
  for (const char* law : {"short_full", "long_full"}) {
    for (const double load : {1e-6, 1.0, 1e5}) {
      CHECK(std::abs(journal_equilibrium(journal_with(law, load)).attitude - std::acos(0.0)) <
            4 * epsilon);  // rounding
    }
  }
}

TEST_CASE("Equilibrium: nothing to carry is carried at the centre") {
  for (const std::string_view law : film_law_names) {
    INFO(law);
    const JournalEquilibrium rest = journal_equilibrium(journal_with(law, 0.0));
    CHECK(rest.eccentricity_ratio == 0);
    CHECK(rest.force.norm() == 0);
    CHECK(rest.stiffness.allFinite());
    CHECK(rest.damping.allFinite());
    for (const auto& value : rest.eigenvalues) CHECK((std::isfinite(value.real()) && std::isfinite(value.imag())));
  }
}

TEST_CASE("Equilibrium: a journal that does not turn carries nothing, and the message says so") {
  for (const std::string_view law : film_law_names) {
    Scene scene = journal_with(law);
    scene.bodies.front().spin = 0;
    CHECK_THROWS_AS(journal_equilibrium(scene), SceneError);
    CHECK_THROWS_WITH(journal_equilibrium(scene), Catch::Matchers::Contains("bodies[0].spin is 0; allowed is"));
  }
}

TEST_CASE("Equilibrium: a journal that turns the other way rests in the mirror image") {
  for (const std::string_view law : film_law_names) {
    INFO(law);
    Scene scene = journal_with(law);
    const JournalEquilibrium rest = journal_equilibrium(scene);
    scene.bodies.front().spin *= -1;
    const JournalEquilibrium mirrored = journal_equilibrium(scene);
    const double tolerance = 8 * epsilon;  // rounding of the frame's rotation
    CHECK(std::abs(mirrored.eccentricity.x() + rest.eccentricity.x()) < tolerance);
    CHECK(std::abs(mirrored.eccentricity.y() - rest.eccentricity.y()) < tolerance);
    CHECK(mirrored.attitude == rest.attitude);
    CHECK(mirrored.eccentricity_ratio == rest.eccentricity_ratio);
    CHECK(mirrored.stability() == rest.stability());
    const Eigen::Matrix2d mirror = Eigen::Vector2d(-1, 1).asDiagonal();
    const double scale = rest.stiffness.norm() / (1 - rest.eccentricity_ratio);
    CHECK((mirror * mirrored.stiffness * mirror - rest.stiffness).norm() < 64 * epsilon * scale);  // rounding of e
  }
}

TEST_CASE("Equilibrium: stiffness and damping are the central differences of the film's force") {
  // Pinkus–Sternlicht's second derivative jumps at ε̇ = 0: its differences are of first order in h only.
  const long double h = 1e-9L;
  const auto agree = [](const Eigen::Matrix2d& exact, const Eigen::Matrix2d& differences) {
    return (exact - differences).norm() <
           1e-7 * exact.norm();  // h F''/F', up to 1e-8; rounding of long double over h, 1e-10
  };
  for_each_film_law([&]<class Law>() {
    for (const double load : {0.1, 31.2753, 200.0}) {
      INFO(Law::name << " " << load << " N");
      const Scene scene = journal_with(Law::name, load);
      const JournalEquilibrium rest = journal_equilibrium(scene);
      const double c = scene.joints.front().clearance;
      const long double spin = scene.bodies.front().spin;
      Eigen::Matrix2d stiffness;
      Eigen::Matrix2d damping;
      for (std::size_t i = 0; i < 4; ++i) {
        // Velocities in units of the spin: both steps are small changes of the film's state.
        const long double step = i < 2 ? h * rest.eccentricity_ratio : h * rest.eccentricity_ratio * spin;
        JournalState<long double> up{rest.eccentricity.x(), rest.eccentricity.y(), 0, 0};
        JournalState<long double> down = up;
        up[i] += step;
        down[i] -= step;
        const Vector2<long double> slope =
            (force<Law>(scene, up) - force<Law>(scene, down)) / (2 * step * static_cast<long double>(c));
        (i < 2 ? stiffness : damping).col(static_cast<Eigen::Index>(i % 2)) = -slope.template cast<double>();
      }
      CHECK(agree(rest.stiffness, stiffness));
      CHECK(agree(rest.damping, damping));
    }
  });
}

TEST_CASE("Equilibrium: the eigenvalues are those of mass, damping and stiffness") {
  for (const std::string_view law : film_law_names) {
    INFO(law);
    const Scene scene = journal_with(law);
    const JournalEquilibrium rest = journal_equilibrium(scene);
    const double m = scene.bodies.front().mass;
    // Their product is det K/m², their sum -tr C/m.
    std::complex<double> product = 1;
    std::complex<double> sum = 0;
    for (const auto& value : rest.eigenvalues) {
      product *= value;
      sum += value;
    }
    const double determinant = rest.stiffness.determinant() / (m * m);
    CHECK(std::abs(product - determinant) < 1e-8 * std::abs(determinant));  // rounding: |J| 1e6, smallest 26, 1e-19
    CHECK(std::abs(sum + rest.damping.trace() / m) < 1e-13 * rest.damping.trace() / m);  // rounding
  }
}

TEST_CASE("Equilibrium: an orbit in a full film grows, as slowly as the journal's inertia wants it") {
  for (const char* law : {"short_full", "long_full"}) {
    INFO(law);
    const Scene scene = journal_with(law);
    const JournalEquilibrium rest = journal_equilibrium(scene);
    CHECK(rest.stability() == Stability::grows);
    // m z̈ + C (ż − iω̄z) = 0 at small ε: λ = iω̄ + ω̄² m/C.
    const double half_spin = scene.bodies.front().spin / 2;
    const double growth = half_spin * half_spin * scene.bodies.front().mass / (rest.damping.trace() / 2);
    const double found = rest.eigenvalues.front().real();
    CHECK(std::abs(found / growth - 1) < 0.2);  // terms of order ε², with ε up to 0.12 and factors of some ten
    CHECK(std::abs(std::abs(rest.eigenvalues.front().imag()) / half_spin - 1) < 0.2);  // the same terms
  }
}

TEST_CASE("Equilibrium: a film whose stiffness is beyond double precision is refused, and no number is none") {
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    for (const double spin : {1e150, 1e300, 1e308}) {
      Scene scene = journal_with(Law::name);
      scene.bodies.front().spin = spin;
      try {
        const JournalEquilibrium rest = journal_equilibrium(scene);
        CHECK(rest.stiffness.allFinite());
        CHECK(rest.damping.allFinite());
        for (const auto& value : rest.eigenvalues) CHECK((std::isfinite(value.real()) && std::isfinite(value.imag())));
      } catch (const std::exception& error) {  // what the program ends with is its message
        CHECK_THAT(error.what(), Catch::Matchers::Contains("allowed"));
      }
    }
  });
}

TEST_CASE("Equilibrium: a load that no eccentricity carries is refused, not answered") {
  for (const double load : {1e300, 1e-320}) {
    INFO(load);
    CHECK_THROWS_WITH(journal_equilibrium(journal_with("short_half", load)),
                      Catch::Matchers::Contains("no equilibrium") && Catch::Matchers::Contains("allowed is"));
  }
}

}  // namespace equilibrium_test
