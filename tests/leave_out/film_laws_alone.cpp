// A program that uses the film laws and nothing else. What it is linked with is the test.
#include <cstdio>
#include <cstdlib>

#include "lubjoint/film/law_list.hpp"

int main(int argc, char** argv) {
  const double clearance = argc > 1 ? std::atof(argv[1]) : 2e-4;
  const lubjoint::Bearing<double> bearing(0.04, 0.0098, clearance);
  const lubjoint::Lubricant<double> oil(0.4);
  const lubjoint::JournalMotion<double> motion{{0.3 * clearance, 0}, {0, -1e-3}, 0.0, 52.36};
  lubjoint::for_each_film_law([&]<class Law>() {
    const auto force = lubjoint::film_force<Law>(bearing, oil, lubjoint::film_state(motion, clearance));
    std::printf("%s %.17g %.17g\n", Law::name.data(), force.x(), force.y());
  });
}
