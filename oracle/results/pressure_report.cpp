#include "oracle/results/pressure_report.hpp"

#include <fmt/format.h>

#include <boost/math/constants/constants.hpp>

#include "oracle/plot/gnuplot.hpp"
#include "oracle/reynolds/film_integral.hpp"

namespace lubjoint::reports {

namespace {
constexpr double pi_v = boost::math::constants::pi<double>();
}

oracle::PressureField one_dimensional_pressure(oracle::OneDimensionalFilm film, const Bearing<double>& bearing,
                                               const Lubricant<double>& oil, const PolarFilmState<double>& state,
                                               int angles, int stations) {
  oracle::PressureField field;
  for (int i = 0; i < angles; ++i) field.theta.push_back(2 * pi_v * i / (angles - 1));
  for (int j = 0; j < stations; ++j) field.z.push_back(bearing.length() * (j / (stations - 1.0) - 0.5));
  const bool along = entry_of(film).limit() == BearingLimit::short_bearing;
  for (const double theta : field.theta) {
    const double middle = film_pressure_by_quadrature(film, bearing, oil, state, theta).value;
    for (const double z : field.z) {
      const double share = 2 * z / bearing.length();  // the short film is a parabola along z, whatever θ
      field.pressure.push_back(along ? middle * (1 - share) * (1 + share) : middle);
    }
  }
  return field;
}

std::string pressure_csv(const oracle::PressureField& field) {
  std::string csv = "theta,z,pressure\n";
  for (std::size_t i = 0; i < field.theta.size(); ++i) {
    for (std::size_t j = 0; j < field.z.size(); ++j) {
      csv += fmt::format("{},{},{}\n", field.theta[i], field.z[j], field.pressure[i * field.z.size() + j]);
    }
  }
  return csv;
}

void draw_pressure(const oracle::PressureField& field, const std::string& film, const PolarFilmState<double>& state,
                   const std::filesystem::path& folder) {
  Plot plot;
  plot.width = 1300;
  plot.height = 520;
  plot.script = fmt::format(
      "set multiplot layout 1,2 title '{}: eccentricity ratio {:.6g}, slip rate {:.6g} 1/s, squeeze rate {:.6g} 1/s' "
      "noenhanced\nset tics nomirror out\nset xrange [0:360]\nset xtics 60\n"
      "set xlabel 'angle from the maximum film [deg]'\n$field << EOD\n",
      film, state.eccentricity_ratio, state.slip_rate, state.squeeze_rate);
  const std::size_t stations = field.z.size();
  for (std::size_t i = 0; i < field.theta.size(); ++i) {
    for (std::size_t j = 0; j < stations; ++j) {
      plot.script += fmt::format("{:.7g} {:.7g} {:.7g}\n", 180 / pi_v * field.theta[i], 1e3 * field.z[j],
                                 1e-6 * field.pressure[i * stations + j]);
    }
    plot.script += '\n';
  }
  plot.script += "EOD\n$middle << EOD\n";
  for (std::size_t i = 0; i < field.theta.size(); ++i) {
    plot.script +=
        fmt::format("{:.7g} {:.7g}\n", 180 / pi_v * field.theta[i], 1e-6 * field.pressure[i * stations + stations / 2]);
  }
  plot.script += fmt::format(
      "EOD\nset grid lc rgb '#dddddd'\nset title 'At z = {0:.3g} mm'\nset ylabel 'pressure [MPa]'\n"
      "plot $middle with lines lw 1.5 lc rgb '#0072b2' notitle\n"
      "unset grid\nset title 'Pressure [MPa]'\nset ylabel 'z [mm]'\nset yrange [{1:.7g}:{2:.7g}]\n"
      "set palette defined (0 '#440154', 1 '#31688e', 2 '#35b779', 3 '#fde725')\n"
      "plot $field using 1:2:3 with image notitle\nunset multiplot\n",
      1e3 * field.z[stations / 2], 1e3 * field.z.front(), 1e3 * field.z.back());
  draw(plot, folder, "pressure");
}

}  // namespace lubjoint::reports
