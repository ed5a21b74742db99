#include "oracle/verify/states/golden_states.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>

#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::verify {

namespace {

/// A table of the golden data: which laws a row speaks about is in its first column.
struct Source {
  const char* file;
  const char* subject;  ///< name of the first column; null where the table is about one law
};

Source source_of(Quantities quantities) {
  switch (quantities) {
    case Quantities::polar:
      return {"film_force.csv", "law"};
    case Quantities::transition:
      return {"transition.csv", "law"};
    case Quantities::extent:
      return {"film_extent.csv", "extent"};
    case Quantities::pressure:
      return {"film_pressure.csv", "field"};
    case Quantities::contact:
      return {"dry_contact.csv", nullptr};
    case Quantities::losses:
      return {"film_losses.csv", "law"};
    case Quantities::equilibrium:
      return {"equilibrium.csv", "law"};
    case Quantities::coefficients:
      return {"loaded_coefficients.csv", "law"};
    case Quantities::cartesian:
    case Quantities::wrench:
    case Quantities::dimensionless:
      break;
  }
  return {"joint_wrench.csv", "law"};
}

/// Does a row with this law, extent or pressure field answer for the law? Where the field is cut off, only inside.
bool speaks_for(std::string_view subject, Quantities quantities, Law law, const State& state) {
  const bool of_field = quantities == Quantities::extent || quantities == Quantities::pressure;
  if (of_field && facts_of(law).squeeze_only) return false;  // theirs are those of a = 0
  if (quantities == Quantities::extent) {
    return subject == (is_full(law) ? "full" : is_half(law) ? "half" : "dynamic");
  }
  if (quantities != Quantities::pressure) return subject == name_of(law);
  std::string_view field = name_of(law);  // long_half and long_dynamic have their own
  if (is_short(law)) field = "short";
  if (law == "long_full"_law || law == "long_half_eq5"_law) field = "long_eq5";
  if (law == "pinkus_sternlicht"_law || subject != field) return false;
  if (is_full(law)) return true;
  const Solution s = solve(Quantities::extent, law, state);
  const Real turn = 2 * pi<Real>();
  const Real past_start = state.theta - s.theta_s;
  return past_start - turn * std::floor(past_start / turn) < s.theta_e - s.theta_s;
}

/// ω and γ̇ with ε(ω − 2γ̇) = a. False if there are none.
bool set_slip_rate(State& state, double a, std::size_t row) {
  const double ratio = state.eccentricity_ratio;
  if (ratio == 0) return a == 0;
  const double whole = a / ratio;
  const double rest = std::fma(-ratio, whole, a) / ratio;  // exact but for the division
  if (rest != 0) {
    state.omega = whole;
    state.attitude_rate = -rest / 2;
    return true;
  }
  // Three ways to split it that are exact in binary, so that spin and attitude rate both matter.
  constexpr double spins[] = {2, 0.5, -1}, attitudes[] = {0.5, -0.25, -1};
  state.omega = spins[row % 3] * whole;
  state.attitude_rate = attitudes[row % 3] * whole;
  return true;
}

bool can_be_asked(Quantities quantities, const State& state) {
  for (const StateColumn& column : state_columns(quantities)) {
    const double size = std::abs(state.*column.value);
    if (size != 0 && !(size <= largest_in_double && size >= 1 / largest_in_double)) return false;
  }
  return quantities != Quantities::pressure || std::abs(std::sin(state.theta)) >= 1e-3;
}

class GoldenReader {
 public:
  GoldenReader(Quantities quantities, const std::filesystem::path& folder)
      : quantities_(quantities),
        source_(source_of(quantities)),
        table_(text_of(folder / source_.file), (folder / source_.file).string()) {}

  std::vector<State> states() const {
    std::vector<State> list;
    std::vector<std::shared_ptr<GoldenAnswers>> answers;
    std::map<std::string, std::size_t> known;  // inputs as they are printed, to places in the list; npos: not asked
    const auto subject_of = [&](std::size_t row) {
      constexpr std::string_view of_contact = "lankarani_nikravesh";
      return source_.subject ? table_.field(row, table_.column(source_.subject)) : of_contact;
    };
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      State state;
      const std::string inputs = read(row, state);
      const auto [place, is_new] = known.try_emplace(inputs, list.size());
      if (is_new) {
        if (!finish(row, known.size(), state)) place->second = std::string::npos;
        if (place->second != std::string::npos) {
          answers.push_back(std::make_shared<GoldenAnswers>(GoldenAnswers{source_.file, {}}));
          state.golden = answers.back();
          list.push_back(state);
        }
      }
      if (place->second == std::string::npos) continue;
      for (std::size_t law = 0; law < every_law_count; ++law) {
        if (!speaks_for(subject_of(row), quantities_, Law{law}, list[place->second])) continue;
        answers[place->second]->row[law] = {answer(row), row + 2};
      }
    }
    return list;
  }

 private:
  static std::string text_of(const std::filesystem::path& file) {
    try {
      return reports::read_input(file.string());
    } catch (const std::invalid_argument&) {
      throw std::invalid_argument("golden data \"" + file.string() +
                                  "\" can't be read; allowed is the folder data/golden that comes with lubjoint");
    }
  }

  /// Fills what table and state name alike. @returns all inputs as they are printed
  std::string read(std::size_t row, State& state) const {
    std::string inputs;
    const auto fill = [&](std::string_view name, double State::*value) {
      const std::size_t column = table_.column(name);
      state.*value = table_.number(row, column);
      inputs.append(table_.field(row, column)).append(",");
    };
    if (quantities_ == Quantities::equilibrium) {
      // The journal of a table's row may be loaded in any direction; here it is along −y, in a bearing at rest.
      for (const StateColumn& column : state_columns(Quantities::equilibrium)) {
        if (column.name != "omega" && column.name != "load") fill(column.name, column.value);
      }
      fill("omega_sum", &State::omega);
      fill("load_x", &State::ex);
      fill("load_y", &State::load);
      state.load = -state.load;
      return inputs;
    }
    for (const StateColumn& column : state_columns(quantities_)) {
      const bool is_rate = column.name == "omega" || column.name == "attitude_rate";
      if (is_rate && is_polar(quantities_)) continue;  // the table has the slip rate
      if (quantities_ == Quantities::extent && column.name == "eccentricity_ratio") continue;
      fill(column.name, column.value);
    }
    if (is_polar(quantities_)) inputs.append(table_.field(row, table_.column("slip_rate")));
    return inputs;
  }

  /// What the table does not say. False if the row is none to ask about.
  bool finish(std::size_t row, std::size_t number, State& state) const {
    if (quantities_ == Quantities::equilibrium && (state.ex != 0 || state.load <= 0)) return false;
    // Two of the laws of contact have no loss where nothing is given back.
    if (quantities_ == Quantities::contact && state.restitution == 0) return false;
    if (quantities_ == Quantities::extent) state.eccentricity_ratio = 0.5;  // any: the film's ends don't depend on it
    if (is_polar(quantities_) && !set_slip_rate(state, table_.number(row, table_.column("slip_rate")), number)) {
      return false;
    }
    return can_be_asked(quantities_, state);
  }

  std::array<Real, most_answers> answer(std::size_t row) const {
    std::array<Real, most_answers> result{};
    std::size_t k = 0;
    for (const std::string_view name : answer_columns(quantities_)) {
      const std::string_view field = table_.field(row, table_.column(name));
      if (field.empty() && name == "side_flow") {  // a long bearing has none
        result[k++] = std::numeric_limits<Real>::quiet_NaN();
        continue;
      }
      const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), result[k++]);
      if (error == std::errc() && end == field.data() + field.size()) continue;
      table_.refuse(row, std::string(name) + " is \"" + std::string(field) + "\"; allowed is a number");
    }
    return result;
  }

  Quantities quantities_;
  Source source_;
  reports::CsvTable table_;
};

}  // namespace

std::vector<State> golden_states(Quantities quantities, const std::filesystem::path& folder) {
  if (quantities == Quantities::dimensionless) return {};  // a table's numbers are exact in SI units
  try {
    return GoldenReader(quantities, folder).states();
  } catch (const reports::CsvError& error) {
    throw std::invalid_argument(error.what() + std::string("; allowed is the golden data that comes with lubjoint"));
  }
}

}  // namespace lubjoint::verify
