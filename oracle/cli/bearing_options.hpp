/// The four options that describe a bearing and its oil.
#pragma once

#include "lubjoint/film/bearing.hpp"
#include "oracle/cli/command.hpp"

namespace lubjoint::cli {

struct BearingOptions {
  double viscosity = 0;
  double length = 0;
  double radius = 0;
  double clearance = 0;

  void add(CLI::App& command) {
    command.add_option("--viscosity", viscosity, "Dynamic viscosity [Pa s]")->required();
    command.add_option("--length", length, "Bearing length [m]")->required();
    command.add_option("--radius", radius, "Journal radius [m]")->required();
    command.add_option("--clearance", clearance, "Radial clearance [m]")->required();
  }
  Bearing<double> bearing() const { return {length, radius, clearance}; }
  Lubricant<double> oil() const { return Lubricant<double>(viscosity); }
};

}  // namespace lubjoint::cli
