#include "array_rows.hpp"
#include "lubjoint/joint/touching_journal.hpp"

using namespace lubjoint;
using namespace lubjoint::c;

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
    const TransitionTolerances<double> tolerances(contact->e0, contact->e1);
    const ContactSurface<double> surface{contact->stiffness, contact->restitution};
    require_contact(surface, contact->impact_speed);
    with_law(law, geometry, [&]<class Law>(const Law& named) {
      const auto film = [&](const Bearing<double>& wide, const FilmState<double>& state) {
        if constexpr (CompiledLaw<Law>) {
          return film_force(named, wide, oil, state);
        } else {
          return film_force<Law>(wide, oil, state);
        }
      };
      for_rows(n, fx, fy, [&](std::size_t i) {
        return touching_journal_force_of(geometry, tolerances, surface, motion_at(*motion, i), contact->impact_speed,
                                         film);
      });
    });
  });
}
