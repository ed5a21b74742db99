/// Pressure fields as people compare them: CSV over θ and z, and a picture.
#pragma once

#include <filesystem>
#include <string>

#include "oracle/reynolds/film_name.hpp"
#include "oracle/reynolds/finite_length.hpp"

namespace lubjoint::reports {

/// Field of a short or long film on the grid that a finite-length field has; a long film's does not change with z.
oracle::PressureField one_dimensional_pressure(oracle::OneDimensionalFilm film, const Bearing<double>& bearing,
                                               const Lubricant<double>& oil, const PolarFilmState<double>& state,
                                               int angles, int stations);

/// theta [rad], z [m], pressure [Pa]; θ outermost.
std::string pressure_csv(const oracle::PressureField& field);

/// pressure.svg and pressure.png in a folder.
void draw_pressure(const oracle::PressureField& field, const std::string& film, const PolarFilmState<double>& state,
                   const std::filesystem::path& folder);

}  // namespace lubjoint::reports
