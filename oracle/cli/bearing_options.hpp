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
  /// @throws std::invalid_argument that names the option
  Bearing<double> bearing() const {
    require_positive("--length", length);
    require_positive("--radius", radius);
    require_positive("--clearance", clearance);
    require_option("--clearance", clearance, clearance < radius, "less than --radius, the journal's");
    return {length, radius, clearance};
  }
  Lubricant<double> oil() const {
    require_positive("--viscosity", viscosity);
    return Lubricant<double>(viscosity);
  }

 private:
  static void require_positive(const std::string& name, double given) {
    require_option(name, given, given > 0, "a finite number above 0");
  }
};

}  // namespace lubjoint::cli
