/// Where the film begins and ends, by root finding on its pressure.
#pragma once

#include "lubjoint/film/extent.hpp"
#include "oracle/reynolds/narrow_gap.hpp"

namespace lubjoint::oracle {

/// Window of a film. The dynamic film is where the short bearing's pressure is positive: its two zeros are bracketed by
/// sampling the pressure around the bearing and refined by TOMS 748, each on its own. They are exact to rounding
/// relative to their distance from the minimum film or to a hundredth of the dip's width, whichever is larger.
/// Full: −π…π; half: −π…0 (a ≥ 0) or 0…π (a < 0); at rest the dynamic film is −π…0.
FilmWindow film_window(FilmExtent extent, const NarrowGap& gap);

}  // namespace lubjoint::oracle
