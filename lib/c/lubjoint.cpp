#include "lubjoint.h"

#include <array>
#include <cerrno>
#include <cmath>
#include <new>
#include <string>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/joint/lubricated_joint.hpp"
#include "lubjoint/joint/transition.hpp"

namespace {

using namespace lubjoint;

thread_local std::array<char, 512> message{};

void say(const char* text) noexcept {
  std::size_t i = 0;
  for (; text[i] != '\0' && i + 1 < message.size(); ++i) message[i] = text[i];
  message[i] = '\0';
}

double at(const lubjoint_in& array, std::size_t i) {
  return *reinterpret_cast<const double*>(reinterpret_cast<const char*>(array.data) +
                                          static_cast<std::ptrdiff_t>(i) * array.stride);
}

void put(const lubjoint_out& array, std::size_t i, double value) {
  *reinterpret_cast<double*>(reinterpret_cast<char*>(array.data) + static_cast<std::ptrdiff_t>(i) * array.stride) =
      value;
}

template <class Pointer>
void require(const char* name, const Pointer& pointer) {
  if (pointer == nullptr) throw std::invalid_argument(std::string(name) + " is a null pointer");
}

void require(const lubjoint_motion& m) {
  require("ex", m.ex.data);
  require("ey", m.ey.data);
  require("vx", m.vx.data);
  require("vy", m.vy.data);
  require("omega_bearing", m.omega_bearing.data);
  require("omega_journal", m.omega_journal.data);
}

struct OutOfRange : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::string in_row(std::size_t i, const std::string& what) { return "row " + std::to_string(i) + ": " + what; }

/// Runs the rows; a row without a film is named.
template <class Row>
void for_rows(std::size_t n, lubjoint_out first, lubjoint_out second, const Row& row) {
  for (std::size_t i = 0; i < n; ++i) {
    try {
      const Vector2<double> force = row(i);
      if (!std::isfinite(force.x()) || !std::isfinite(force.y())) {
        throw OutOfRange(in_row(i, "the force is beyond the range of double precision; allowed are smaller rates"));
      }
      put(first, i, force.x());
      put(second, i, force.y());
    } catch (const FilmDomainError& error) {
      throw FilmDomainError(in_row(i, error.what()));
    }
  }
}

/// Turns exceptions into error numbers.
template <class Work>
int guarded(const Work& work) noexcept {
  try {
    work();
    return 0;
  } catch (const FilmDomainError& error) {
    say(error.what());
    return EDOM;
  } catch (const OutOfRange& error) {
    say(error.what());
    return ERANGE;
  } catch (const std::bad_alloc&) {
    say("no memory");
    return ENOMEM;
  } catch (const std::exception& error) {
    say(error.what());
    return EINVAL;
  }
}

JournalMotion<double> motion_at(const lubjoint_motion& m, std::size_t i) {
  return {{at(m.ex, i), at(m.ey, i)}, {at(m.vx, i), at(m.vy, i)}, at(m.omega_bearing, i), at(m.omega_journal, i)};
}

Bearing<double> bearing_of(const lubjoint_bearing& b) { return {b.length, b.radius, b.clearance}; }

}  // namespace

const char* lubjoint_message(void) { return message.data(); }

const char* lubjoint_version(void) { return LUBJOINT_VERSION; }

const char* lubjoint_law_name(size_t i) { return i < film_law_names.size() ? film_law_names[i].data() : nullptr; }

int lubjoint_polar_force(const char* law, const lubjoint_bearing* bearing, size_t n, lubjoint_in eccentricity_ratio,
                         lubjoint_in slip_rate, lubjoint_in squeeze_rate, lubjoint_out radial,
                         lubjoint_out tangential) {
  return guarded([&] {
    require("law", law);
    require("bearing", bearing);
    if (n > 0) {
      require("eccentricity_ratio", eccentricity_ratio.data);
      require("slip_rate", slip_rate.data);
      require("squeeze_rate", squeeze_rate.data);
      require("radial", radial.data);
      require("tangential", tangential.data);
    }
    const Bearing<double> geometry = bearing_of(*bearing);
    const Lubricant<double> oil(bearing->viscosity);
    with_film_law(law, [&]<class Law>() {
      const double scale = force_scale(Law::limit, geometry, oil);
      for_rows(n, radial, tangential, [&](std::size_t i) {
        const PolarForce<double> ratio = polar_force_ratio<Law>(
            PolarFilmState<double>(at(eccentricity_ratio, i), at(slip_rate, i), at(squeeze_rate, i)));
        return Vector2<double>(scale * ratio.radial, scale * ratio.tangential);
      });
    });
  });
}

int lubjoint_journal_force(const char* law, const lubjoint_bearing* bearing, size_t n, const lubjoint_motion* motion,
                           lubjoint_out fx, lubjoint_out fy) {
  return guarded([&] {
    require("law", law);
    require("bearing", bearing);
    require("motion", motion);
    if (n > 0) {
      require(*motion);
      require("fx", fx.data);
      require("fy", fy.data);
    }
    with_film_law(law, [&]<class Law>() {
      const LubricatedJoint<Law, double> joint(bearing_of(*bearing), Lubricant<double>(bearing->viscosity));
      for_rows(n, fx, fy,
               [&](std::size_t i) { return joint.force(film_state(motion_at(*motion, i), bearing->clearance)); });
    });
  });
}

int lubjoint_transition_force(const char* law, const lubjoint_bearing* bearing, const lubjoint_contact* contact,
                              size_t n, const lubjoint_motion* motion, lubjoint_out fx, lubjoint_out fy) {
  return guarded([&] {
    require("law", law);
    require("bearing", bearing);
    require("contact", contact);
    require("motion", motion);
    if (n > 0) {
      require(*motion);
      require("fx", fx.data);
      require("fy", fy.data);
    }
    const Bearing<double> geometry = bearing_of(*bearing);
    const Lubricant<double> oil(bearing->viscosity);
    const TransitionBand<double> band(contact->e0, contact->e1);
    const DryContact<double> dry(contact->stiffness, contact->restitution);
    detail::require_positive("impact_speed", contact->impact_speed, "m/s");
    with_film_law(law, [&]<class Law>() {
      for_rows(n, fx, fy, [&](std::size_t i) {
        return transition_force<Law>(geometry, oil, band, dry, motion_at(*motion, i), contact->impact_speed);
      });
    });
  });
}

int lubjoint_joint_moments(size_t n, lubjoint_in ex, lubjoint_in ey, lubjoint_in sx_i, lubjoint_in sy_i,
                           lubjoint_in sx_j, lubjoint_in sy_j, lubjoint_in fx, lubjoint_in fy, lubjoint_out mz_bearing,
                           lubjoint_out mz_journal) {
  return guarded([&] {
    if (n == 0) return;
    const std::array<lubjoint_in, 8> inputs = {ex, ey, sx_i, sy_i, sx_j, sy_j, fx, fy};
    constexpr std::array<const char*, 8> names = {"ex", "ey", "sx_i", "sy_i", "sx_j", "sy_j", "fx", "fy"};
    for (std::size_t k = 0; k < inputs.size(); ++k) require(names[k], inputs[k].data);
    require("mz_bearing", mz_bearing.data);
    require("mz_journal", mz_journal.data);
    for_rows(n, mz_bearing, mz_journal, [&](std::size_t i) {
      const JournalMotion<double> motion{{at(ex, i), at(ey, i)}, {0, 0}, 0, 0};
      const JointKinematics<double> joint{{at(sx_i, i), at(sy_i, i)}, {at(sx_j, i), at(sy_j, i)}, motion};
      const JointWrenches<double> wrenches = joint_wrenches(joint, Vector2<double>(at(fx, i), at(fy, i)));
      return Vector2<double>(wrenches.bearing.moment, wrenches.journal.moment);
    });
  });
}
