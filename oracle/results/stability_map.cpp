#include "oracle/results/stability_map.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "lubjoint/film/rotor_modes.hpp"
#include "lubjoint/film/steady_place.hpp"
#include "oracle/files/files.hpp"
#include "oracle/plot/figure.hpp"
#include "oracle/plot/gnuplot.hpp"

namespace lubjoint::reports {

namespace {

using Wide = long double;
using Matrix = Eigen::Matrix<Wide, 2, 2>;

RotorMode<Wide> mode_of(const CoefficientRow& rest, double mass) {
  return leading_mode<Wide>(rest.stiffness.cast<Wide>(), rest.damping.cast<Wide>(), Wide(mass),
                            std::abs(Wide(rest.omega)));
}

/// Where stability changes along ε, at the speed W/(S f(ε)) that each ε takes, f = |F|/(Sω).
std::vector<CriticalSpeed> critical_speeds(const RotorQuestion& question) {
  const SteadyLaw law = steady_law(question.film.law, question.film.table.get());
  const Wide scale = force_scale(law.limit, question.film.bearing, question.film.oil);
  const Wide clearance = question.film.bearing.clearance();
  const auto speed_at = [&](const SteadyPlace<Wide>& place) {
    const PolarForce<Wide> f = law.force_ratio(place.film(1));
    return Wide(question.load / (scale * std::hypot(f.radial, f.tangential)));
  };
  const auto is_stable = [&](Wide logit) {
    const SteadyPlace<Wide> place = detail::place_at_logit(logit);
    const CoefficientRatios<Wide> ratios = law.coefficients(place, 1);
    const RotorThreshold<Wide> threshold = routh_threshold<Wide>(ratios.stiffness, ratios.damping);
    return Wide(*question.mass) * clearance * speed_at(place) / scale < threshold.critical_mass;
  };
  // From ε near 1, where the speed is low, to ε = 1e-13; any band of stability wider than a step is found.
  constexpr Wide from = 30, to = -30, step = Wide(1) / 16;
  std::vector<CriticalSpeed> speeds;
  bool was_stable = is_stable(from);
  for (Wide logit = from - step; logit >= to; logit -= step) {
    const bool now_stable = is_stable(logit);
    if (now_stable != was_stable) {
      Wide low = logit;
      Wide high = logit + step;
      for (int i = 0; i < 64; ++i) {
        const Wide middle = (low + high) / 2;
        (is_stable(middle) == was_stable ? high : low) = middle;
      }
      speeds.push_back({static_cast<double>(speed_at(detail::place_at_logit(Wide((low + high) / 2)))), was_stable});
    }
    was_stable = now_stable;
  }
  return speeds;
}

std::string value_or_empty(const std::optional<double>& value) { return value ? number(*value) : std::string(); }

std::string mass_text(double mass) {
  if (std::isinf(mass)) return "every mass is stable";
  if (mass == 0) return "no mass is stable";
  return fmt::format("{:.6g} kg", mass);
}

CoefficientRow rest_of(const RotorQuestion& question) {
  const auto rest = coefficients_under(question.film, question.load, question.omega);
  if (rest) return *rest;
  throw std::invalid_argument(fmt::format(
      "load is {} N at {} rad/s; allowed is a load that the film carries at an eccentricity ratio from 1e-300 to "
      "1 - 1e-15",
      question.load, question.omega));
}

std::optional<CoefficientRow> rest_at(const RotorQuestion& question, MapAxis axis, double value) {
  const bool by_speed = axis == MapAxis::speed;
  return coefficients_under(question.film, by_speed ? question.load : value, by_speed ? value : question.omega);
}

}  // namespace

const char* rotor_stability_word(RotorStability stability) {
  return stability == RotorStability::stable ? "yes" : stability == RotorStability::unstable ? "no" : "undecided";
}

RotorStability rotor_stability(const CoefficientRow& rest, double mass) {
  const bool by_routh = mass < rest.critical_mass;
  const bool by_eigenvalues = mode_of(rest, mass).growth < 0;
  if (by_routh != by_eigenvalues) return RotorStability::undecided;
  return by_routh ? RotorStability::stable : RotorStability::unstable;
}

RotorAnswer rotor_answer(const RotorQuestion& question) {
  RotorAnswer answer{rest_of(question), 0, {}, {}, {}};
  const double spin = std::abs(question.omega);
  const double unit = question.load / (question.film.bearing.clearance() * spin * spin);
  const RotorThreshold<Wide> by_eigenvalues = eigenvalue_threshold<Wide>(
      answer.rest.stiffness.cast<Wide>(), answer.rest.damping.cast<Wide>(), Wide(unit), Wide(spin));
  answer.mass_by_eigenvalues = static_cast<double>(by_eigenvalues.critical_mass);
  if (by_eigenvalues.whirl_frequency) {
    answer.whirl_by_eigenvalues = static_cast<double>(*by_eigenvalues.whirl_frequency / spin);
  }
  if (!question.mass) return answer;
  answer.stability = rotor_stability(answer.rest, *question.mass);
  answer.critical_speeds = critical_speeds(question);
  return answer;
}

std::string rotor_text(const RotorQuestion& question, const RotorAnswer& answer) {
  const CoefficientRow& rest = answer.rest;
  std::string text = fmt::format(
      "law                 {}\nload                {:.6g} N\nspin                {:.6g} rad/s\n"
      "eccentricity ratio  {:.6f}\nattitude angle      {:.3f} deg (from the load to e, positive with the spin)\n"
      "thinnest film       {:.6g} m\ncritical mass       {} (Routh)\n                    {} (eigenvalues)\n",
      question.film.law, question.load, question.omega, rest.eccentricity_ratio, rest.attitude * 180 / std::numbers::pi,
      question.film.bearing.clearance() * (1 - rest.eccentricity_ratio), mass_text(rest.critical_mass),
      mass_text(answer.mass_by_eigenvalues));
  if (rest.whirl_ratio) text += fmt::format("whirl over spin     {:.6f}\n", *rest.whirl_ratio);
  if (!question.mass) return text;
  text += fmt::format("mass                {:.6g} kg\nstable              {}\n", *question.mass,
                      rotor_stability_word(*answer.stability));
  if (answer.critical_speeds.empty()) text += "critical speed      none under this load\n";
  for (const CriticalSpeed& each : answer.critical_speeds) {
    text += fmt::format("critical speed      {:.6g} rad/s (stable {})\n", each.omega,
                        each.stable_below ? "below" : "above");
  }
  return text;
}

nlohmann::ordered_json rotor_json(const RotorQuestion& question, const RotorAnswer& answer) {
  using Json = nlohmann::ordered_json;
  const CoefficientRow& rest = answer.rest;
  const auto finite = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
  const auto maybe = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
  Json speeds = Json::array();
  for (const CriticalSpeed& each : answer.critical_speeds) {
    speeds.push_back({{"omega", each.omega}, {"stable_below", each.stable_below}});
  }
  const std::string warning = stability_warning(question.film.law, question.film.table.get());
  return {{"law", question.film.law},
          {"load", question.load},
          {"omega", question.omega},
          {"eccentricity_ratio", rest.eccentricity_ratio},
          {"attitude", rest.attitude},
          {"every_mass_is_stable", std::isinf(rest.critical_mass)},
          {"critical_mass", finite(rest.critical_mass)},
          {"critical_mass_by_eigenvalues", finite(answer.mass_by_eigenvalues)},
          {"whirl_ratio", maybe(rest.whirl_ratio)},
          {"whirl_ratio_by_eigenvalues", maybe(answer.whirl_by_eigenvalues)},
          {"mass", maybe(question.mass)},
          {"stable", answer.stability ? Json(rotor_stability_word(*answer.stability)) : Json(nullptr)},
          {"critical_speeds", speeds},
          {"warning", warning.empty() ? Json(nullptr) : Json(warning)}};
}

std::string map_csv(const RotorQuestion& question, const StabilityMap& map) {
  std::string csv = "load,omega,mass,eccentricity_ratio,critical_mass,whirl_ratio,growth_rate,stable\n";
  for (const double value : map.values) {
    const auto rest = rest_at(question, map.axis, value);
    const bool by_speed = map.axis == MapAxis::speed;
    for (const double mass : map.masses) {
      csv += number(by_speed ? question.load : value) + "," + number(by_speed ? value : question.omega) + "," +
             number(mass);
      if (!rest) {
        csv += ",,,,,\n";
        continue;
      }
      csv += "," + number(rest->eccentricity_ratio) + "," +
             (std::isinf(rest->critical_mass) ? "inf" : number(rest->critical_mass)) + "," +
             value_or_empty(rest->whirl_ratio) + "," + number(static_cast<double>(mode_of(*rest, mass).growth)) + "," +
             rotor_stability_word(rotor_stability(*rest, mass)) + "\n";
    }
  }
  return csv;
}

void draw_map(const RotorQuestion& question, const StabilityMap& map, const std::filesystem::path& folder,
              const std::string& name) {
  Plot plot;
  plot.width = 900;
  plot.height = 620;
  std::string stable = "$stable << EOD\n", unstable = "$unstable << EOD\n", edge = "$edge << EOD\n";
  for (const double value : map.values) {
    const auto rest = rest_at(question, map.axis, value);
    if (!rest) continue;
    const double place = map.axis == MapAxis::speed ? std::abs(value) : value;
    for (const double mass : map.masses) {
      const bool decays = rotor_stability(*rest, mass) == RotorStability::stable;
      (decays ? stable : unstable) += fmt::format("{} {}\n", place, mass);
    }
    if (std::isfinite(rest->critical_mass) && rest->critical_mass > 0) {
      edge += fmt::format("{} {}\n", place, rest->critical_mass);
    }
  }
  // A block without a line is an error to gnuplot; a point that is no number is not drawn.
  plot.script = stable + "NaN NaN\nEOD\n" + unstable + "NaN NaN\nEOD\n" + edge + "NaN NaN\nEOD\n" + plain_axes;
  plot.script += fmt::format(
      "set title 'Stability of a rigid rotor, {}' noenhanced\nset xlabel '{}'\nset ylabel 'mass per bearing [kg]'\n"
      "set logscale xy\nset format xy '%g'\nset xrange [{}:{}]\nset yrange [{}:{}]\nset key outside bottom center "
      "horizontal\n"
      "plot $stable using 1:2 with points pt 7 ps 0.5 lc rgb '#0072b2' title 'stable', "
      "$unstable using 1:2 with points pt 6 ps 0.5 lc rgb '#d55e00' title 'unstable', "
      "$edge using 1:2 with lines lw 2 lc rgb '#000000' title 'critical mass'\n",
      question.film.law, map.axis == MapAxis::speed ? "spin [rad/s]" : "load [N]", std::abs(map.values.front()),
      std::abs(map.values.back()), map.masses.front(), map.masses.back());
  draw(plot, folder, name);
}

}  // namespace lubjoint::reports
