/// Which part of a bearing's gap shears oil.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lubjoint {

/// film: where the law's film carries pressure (pinkus_sternlicht, moes_impedance and butenschoen: the dynamic film's
/// extent);
/// flooded: the whole gap, whatever cavitates (Petroff);
/// striated: behind a half film the cavity carries, in streaks, the oil that left at the minimum film. It takes the
/// flow to be steady and continuous: half films alone, and an approximation where the journal moves along e.
enum class ShearExtent { film, flooded, striated };

/// Their names in scenes and options, in order.
inline constexpr std::array<std::string_view, 3> shear_extent_names = {"film", "flooded", "striated"};

/// The shear extent of that name.
/// @throws std::invalid_argument that lists the names there are
inline ShearExtent shear_extent(std::string_view name) {
  for (std::size_t i = 0; i < shear_extent_names.size(); ++i) {
    if (shear_extent_names[i] == name) return static_cast<ShearExtent>(i);
  }
  throw std::invalid_argument("there is no shear \"" + std::string(name) + "\"; allowed are film, flooded, striated");
}

}  // namespace lubjoint
