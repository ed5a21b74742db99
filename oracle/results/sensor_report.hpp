/// What people and programs read of sensors, in the plane and in space.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lubjoint/motion/multibody_results.hpp"

namespace lubjoint::reports {

/// Largest and smallest value of each quantity, and when: name, then QUANTITY = {max, t_max, min, t_min}.
/// @param extremes  of every value of every sensor, in order
template <class AnySensor>
nlohmann::ordered_json sensors_json(const std::vector<AnySensor>& sensors,
                                    const std::vector<SensorExtremes>& extremes) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  std::size_t k = 0;
  for (const AnySensor& sensor : sensors) {
    json.push_back({{"name", sensor.name}});
    for (const char* quantity : sensor_quantities(sensor)) {
      const SensorExtremes& e = extremes[k++];
      json.back()[quantity] = {{"max", e.max.value}, {"t_max", e.max.t}, {"min", e.min.value}, {"t_min", e.min.t}};
    }
  }
  return json;
}

/// The same in words, a line each.
template <class AnySensor>
std::string sensors_text(const std::vector<AnySensor>& sensors, const std::vector<SensorExtremes>& extremes) {
  std::string text;
  std::size_t k = 0;
  for (const AnySensor& sensor : sensors) {
    text += fmt::format("sensor       {}\n", sensor.name);
    for (const char* quantity : sensor_quantities(sensor)) {
      const SensorExtremes& e = extremes[k++];
      text += fmt::format("  {:<10} from {:.6g} at {:.6g} s to {:.6g} at {:.6g} s\n", quantity, e.min.value, e.min.t,
                          e.max.value, e.max.t);
    }
  }
  return text;
}

}  // namespace lubjoint::reports
