#include "oracle/cli/verify_words.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "oracle/cli/name_option.hpp"
#include "oracle/files/data_folder.hpp"
#include "oracle/files/files.hpp"
#include "oracle/verify/states/quantity.hpp"

namespace lubjoint::cli {

namespace {

/// Adapters for a program of one's own.
struct Template {
  std::string_view language;
  const char* file;
};
constexpr std::array templates = {Template{"python", "film.py"},   Template{"octave", "film.m"},
                                  Template{"c", "film.c"},         Template{"cpp", "film.cpp"},
                                  Template{"fortran", "film.f90"}, Template{"julia", "film.jl"}};

std::vector<std::string_view> template_languages() {
  std::vector<std::string_view> names;
  for (const Template& each : templates) names.push_back(each.language);
  return names;
}

}  // namespace

std::string verify_template(const std::string& language) {
  require_name("--template", language, template_languages());
  const auto* found = std::ranges::find(templates, language, &Template::language);
  return reports::read_input((reports::data_folder() / "templates" / found->file).string());
}

std::string described_quantities() {
  std::string text =
      "Columns of the states (after id), and those of the answers, SI units; without dimensions, lengths in "
      "clearances,\n"
      "time in 1/omega of the journal in a bearing at rest, force in S omega, S = mu R L^3/c^2 (short) or mu L "
      "R^3/c^2:\n";
  for (const std::string_view name : verify::quantities_names) {
    const verify::Quantities quantities = verify::quantities_of(name);
    text.append("  ").append(name).append("\n    given    ");
    bool first = true;
    for (const verify::StateColumn& column : verify::state_columns(quantities)) {
      text.append(first ? "" : ",").append(column.name);
      first = false;
    }
    text += "\n    answers  id";
    for (const std::string_view column : verify::answer_columns(quantities)) text.append(",").append(column);
    text += '\n';
  }
  return text +
         "coefficients, equilibrium: load along -y [N], bearing at rest; F = -K e - C v in these axes, the first index "
         "is\n"
         "the force's direction; attitude from the load to e, positive in the sense of the spin [rad]. losses: "
         "torques\n"
         "about each body's own centre. Any columns of these three may be given; those that are there are judged.\n"
         "contact: --law lankarani_nikravesh, hunt_crossley, flores, gonthier or auto.\n"
         "id may be left out of answers that keep the order of the states.\n"
         "States with e = 0 come, too. There the radial direction is that of the journal's velocity relative to the\n"
         "bearing, and the force is the limit e -> 0; with e = 0 and no velocity it is 0. No answer may be nan.\n"
         "Exit status: 0 agrees, 1 disagrees, 2 could not be judged, or bad usage.";
}

}  // namespace lubjoint::cli
