/// What the functions of the C interface share. Each has a file of its own: together they are more than GCC inlines.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "film_tables.hpp"
#include "guarded.hpp"
#include "lubjoint.h"
#include "lubjoint/film/batch.hpp"

namespace lubjoint::c {

/// Of this thread, for lubjoint_message.
LastMessage& last_message() noexcept;

inline double at(const lubjoint_in& array, std::size_t i) {
  return *reinterpret_cast<const double*>(reinterpret_cast<const char*>(array.data) +
                                          static_cast<std::ptrdiff_t>(i) * array.stride);
}

inline void put(const lubjoint_out& array, std::size_t i, double value) {
  *reinterpret_cast<double*>(reinterpret_cast<char*>(array.data) + static_cast<std::ptrdiff_t>(i) * array.stride) =
      value;
}

inline void require(const lubjoint_motion& m) {
  require("ex", m.ex.data);
  require("ey", m.ey.data);
  require("vx", m.vx.data);
  require("vy", m.vy.data);
  require("omega_bearing", m.omega_bearing.data);
  require("omega_journal", m.omega_journal.data);
}

/// Runs the rows; a row without a film is named.
template <class Row>
void for_rows(std::size_t n, lubjoint_out first, lubjoint_out second, const Row& row) {
  std::size_t i = 0;
  try {
    for (; i < n; ++i) {
      const Vector2<double> force = row(i);
      if (!std::isfinite(force.x()) || !std::isfinite(force.y())) throw ForceRowError(i);
      put(first, i, force.x());
      put(second, i, force.y());
    }
  } catch (const FilmDomainError& error) {
    throw FilmRowError(i, error.what());
  }
}

/// As guarded, with this library's message.
template <class Work>
int guarded(const Work& work) noexcept {
  return guarded(last_message(), work);
}

inline JournalMotion<double> motion_at(const lubjoint_motion& m, std::size_t i) {
  return {{at(m.ex, i), at(m.ey, i)}, {at(m.vx, i), at(m.vy, i)}, at(m.omega_bearing, i), at(m.omega_journal, i)};
}

inline Bearing<double> bearing_of(const lubjoint_bearing& b) { return {b.length, b.radius, b.clearance}; }

}  // namespace lubjoint::c
