// The arrays' forces are those of one state, bit by bit.
#include <array>
#include <cstdio>

#include "lubjoint/film/batch.hpp"
#include "lubjoint/film/short_full.hpp"

int main() {
  const lubjoint::Bearing<double> bearing(0.04, 0.0098, 0.0002);
  const lubjoint::Lubricant<double> oil(0.4);
  const std::array<double, 5> ex{0, 0.1, -0.3, 0.5, 0.7}, ey{0, 0.2, 0.4, -0.1, 0.3};
  const std::array<double, 5> ux{1, -2, 0, 3, -1}, uy{0, 5, 1, -4, 2};
  std::array<double, 5> fx{}, fy{};
  lubjoint::film_forces("short_full", bearing, oil, lubjoint::FilmStateArrays{ex, ey, ux, uy}, lubjoint::ForceArrays{fx, fy});
  int different = 0;
  const double scale = lubjoint::force_scale(lubjoint::ShortFull::limit, bearing, oil);
  for (std::size_t i = 0; i < ex.size(); ++i) {
    const auto ratio =
        lubjoint::force_ratio<lubjoint::ShortFull>(lubjoint::FilmState<double>({ex[i], ey[i]}, {ux[i], uy[i]}));
    if (fx[i] != scale * ratio.x() || fy[i] != scale * ratio.y()) ++different;
  }
  std::printf("arrays: %d of %zu rows different\n", different, ex.size());
  return different == 0 ? 0 : 1;
}
