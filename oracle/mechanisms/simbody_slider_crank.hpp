/// What Simbody is given of the slider-crank with a lubricated gudgeon pin: it shares the film's law with the library,
/// and nothing else.
#pragma once

#include "lubjoint/film/pinkus_sternlicht.hpp"
#include "oracle/mechanisms/lubricated_slider_crank.hpp"
#include "oracle/mechanisms/simbody_engine.hpp"

namespace lubjoint::mechanisms {

/// Starts extended, with the velocities of the ideal mechanism and e = 0, with the law of Pinkus and Sternlicht.
inline SimbodyProblem simbody_slider_crank(const SliderCrank<double>& m, double crank_speed,
                                           const Bearing<double>& bearing, const Lubricant<double>& oil,
                                           BearingOn side) {
  const IdealMotion<double> ideal = ideal_motion<double>(m, {0, crank_speed, 0});
  return {m.crank_length,
          m.crank_mass,
          m.crank_inertia,
          m.rod_length,
          m.rod_mass,
          m.rod_inertia,
          m.slider_mass,
          crank_speed,
          ideal.rod.rate,
          ideal.slider.value,
          side == BearingOn::rod,
          [bearing, oil](const SimbodyPin& pin) -> std::array<double, 2> {
            const JournalMotion<double> motion{{pin.eccentricity[0], pin.eccentricity[1]},
                                               {pin.velocity[0], pin.velocity[1]},
                                               pin.bearing_spin,
                                               pin.journal_spin};
            const Vector2<double> force =
                film_force<PinkusSternlicht>(bearing, oil, film_state(motion, bearing.clearance()));
            return {force.x(), force.y()};
          }};
}

}  // namespace lubjoint::mechanisms
