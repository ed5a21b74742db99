#include "oracle/verify/states/condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include "oracle/verify/states/solution.hpp"

namespace lubjoint::verify {

namespace {

bool anywhere(Quantities) { return true; }
bool has_rates(Quantities q) { return !is_of_load(q); }
bool in_plane_only(Quantities q) { return !is_polar(q) && !is_of_load(q); }
bool in_motion_only(Quantities q) { return has_rates(q) && q != Quantities::contact; }
bool where_spins_are_given(Quantities q) { return in_plane_only(q) && q != Quantities::contact; }
bool where_omega_is_given(Quantities q) { return is_polar(q) || is_of_load(q); }

bool given_in_polar(const State& s) { return s.ex == 0 && s.ey == 0 && s.vx == 0 && s.vy == 0; }

/// Kinematics of a state; which quantities it was made for is seen from what it says.
Solution kinematics(const State& s) {
  return solve(given_in_polar(s) ? Quantities::polar : Quantities::cartesian, "short_full"_law, s);
}

double ratio_of(const State& s) {
  if (given_in_polar(s)) return s.eccentricity_ratio;
  return static_cast<double>(std::hypot(static_cast<Real>(s.ex), static_cast<Real>(s.ey)) / s.clearance);
}

double attitude_rate_of(const State& s) {
  if (given_in_polar(s)) return s.attitude_rate;
  const Real x = s.ex, y = s.ey, squared = x * x + y * y;
  return squared == 0 ? 0 : static_cast<double>((x * s.vy - y * s.vx) / squared);
}

constexpr std::array<std::string_view, 6> comparator_words = {"<", "<=", "==", "!=", ">=", ">"};

/// Known before a law is: under a load, ε is what it answers.
bool is_declared(const Feature& feature, Quantities quantities) {
  return feature.is_there(quantities) && (!is_of_load(quantities) || feature.name == "omega");
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Sets of states, a bit each.
using Bits = std::vector<std::uint64_t>;

std::size_t count_of(const Bits& x, const Bits& y, const Bits& z) {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += static_cast<std::size_t>(std::popcount(x[i] & y[i] & z[i]));
  return sum;
}

Bits both(const Bits& x, const Bits& y) {
  Bits z(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) z[i] = x[i] & y[i];
  return z;
}

std::vector<Condition> conditions_to_try(Quantities quantities) {
  std::vector<Condition> list;
  for (const Feature& feature : features()) {
    if (!feature.is_there(quantities)) continue;
    if (feature.has_sign) {
      for (const Comparator c : {Comparator::greater, Comparator::less, Comparator::greater_or_equal,
                                 Comparator::less_or_equal, Comparator::equal, Comparator::not_equal}) {
        list.push_back({&feature, c, 0});
      }
    } else if (feature.name == "speed") {
      list.push_back({&feature, Comparator::equal, 0});
      list.push_back({&feature, Comparator::greater, 0});
    } else if (feature.name == "eccentricity_ratio") {
      list.push_back({&feature, Comparator::equal, 0});
      list.push_back({&feature, Comparator::greater, 0});
      for (const double x : {1e-4, 1e-3, 0.01, 0.05, 0.1, 0.2, 0.4, 0.5, 0.6, 0.8}) {
        list.push_back({&feature, Comparator::less, x});
        list.push_back({&feature, Comparator::greater_or_equal, x});
      }
    } else {
      for (const double x : {0.1, 0.05, 0.01, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
        list.push_back({&feature, Comparator::less, x});
        list.push_back({&feature, Comparator::greater_or_equal, x});
      }
    }
  }
  return list;
}

/// Finds conjunctions of at most three conditions for a set of states.
class DomainSearch {
 public:
  DomainSearch(Quantities quantities, const std::vector<State>& states, const std::vector<int>& in_set)
      : conditions_(conditions_to_try(quantities)),
        words_((states.size() + 63) / 64),
        inside_(words_, 0),
        outside_(words_, 0) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (in_set[i] == 1) set(inside_, i);
      if (in_set[i] == 0) set(outside_, i);
    }
    const Feature* feature = nullptr;
    std::vector<double> values(states.size());
    for (const Condition& condition : conditions_) {
      if (condition.feature != feature) {
        feature = condition.feature;
        std::ranges::transform(states, values.begin(), [&](const State& state) { return feature->value(state); });
      }
      Bits bits(words_, 0);
      for (std::size_t i = 0; i < states.size(); ++i) {
        if (condition.holds_for(values[i])) set(bits, i);
      }
      holds_.push_back(std::move(bits));
    }
    all_inside_ = count_of(inside_, inside_, inside_);
    all_outside_ = count_of(outside_, outside_, outside_);
  }

  /// With no state of the others, or where that fails with a few.
  Domain result() {
    if (all_inside_ == 0 || all_outside_ == 0) return {};
    tolerated_ = 0;
    Domain strict = attempt();
    if (!strict.empty()) return strict;
    tolerated_ = all_outside_ / 200;
    return tolerated_ > 0 ? attempt() : strict;
  }

 private:
  /// Each part holds a tenth of the set or is a single condition for half of what is missing: less is chance. What is
  /// said of nine in ten is said.
  Domain attempt() const {
    Domain domain;
    Bits left = inside_;
    std::size_t missing = all_inside_;
    while (100 * missing > all_inside_ && domain.size() < 3) {
      const std::optional<Found> best = best_conjunction(left);
      if (!best) break;
      const bool simple = best->members.size() == 1 && 2 * best->covered >= missing;
      if (10 * best->covered < all_inside_ && !simple) break;
      Conjunction conjunction;
      for (const std::size_t k : best->members) conjunction.push_back(conditions_[k]);
      domain.push_back(std::move(conjunction));
      for (std::size_t i = 0; i < words_; ++i) left[i] &= ~best->bits[i];
      missing -= best->covered;
    }
    return 10 * missing > all_inside_ ? Domain() : domain;
  }

  struct Found {
    std::vector<std::size_t> members;
    Bits bits;
    std::size_t covered;
  };

  static void set(Bits& bits, std::size_t i) { bits[i / 64] |= std::uint64_t{1} << (i % 64); }

  /// Covers most of what is left, and next to nothing else; of those that cover as much the one with fewest conditions.
  std::optional<Found> best_conjunction(const Bits& left) const {
    const Bits every(words_, ~std::uint64_t{0});
    const std::size_t n = conditions_.size();
    std::optional<Found> best;
    const auto consider = [&](std::vector<std::size_t> members, const Bits& x, const Bits& y) {
      const std::size_t covered = count_of(x, y, left);
      // A condition more must win a twentieth.
      if (covered == 0 || (best && covered * 20 <= best->covered * 21)) return;
      if (count_of(x, y, outside_) > tolerated_) return;
      best = Found{std::move(members), both(x, y), covered};
    };
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t covered = count_of(holds_[i], every, left);
      if (covered == 0 || (best && covered <= best->covered)) continue;
      if (count_of(holds_[i], every, outside_) <= tolerated_) best = Found{{i}, holds_[i], covered};
    }
    if (best && best->covered * 100 >= 99 * count_of(left, every, every)) return best;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        if (conditions_[i].feature != conditions_[j].feature) consider({i, j}, holds_[i], holds_[j]);
      }
    }
    if (best && best->covered * 100 >= 99 * count_of(left, every, every)) return best;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        const Bits pair = both(holds_[i], holds_[j]);
        if (best && count_of(pair, every, left) <= best->covered) continue;
        for (std::size_t k = j + 1; k < n; ++k) {
          const auto *f = conditions_[i].feature, *g = conditions_[j].feature, *h = conditions_[k].feature;
          if (f != g && g != h && f != h) consider({i, j, k}, pair, holds_[k]);
        }
      }
    }
    return best;
  }

  std::vector<Condition> conditions_;
  std::vector<Bits> holds_;
  std::size_t words_;
  Bits inside_, outside_;
  std::size_t all_inside_ = 0, all_outside_ = 0, tolerated_ = 0;
};

}  // namespace

const std::vector<Feature>& features() {
  static const std::vector<Feature> list = {
      {"omega_sum", true, [](const State& s) { return s.omega_bearing + s.omega_journal; }, where_spins_are_given},
      {"omega_bearing", true, [](const State& s) { return s.omega_bearing; }, where_spins_are_given},
      {"omega_journal", true, [](const State& s) { return s.omega_journal; }, where_spins_are_given},
      {"omega", true, [](const State& s) { return s.omega; }, where_omega_is_given},
      {"slip_rate", true, [](const State& s) { return static_cast<double>(kinematics(s).a); }, in_motion_only},
      {"squeeze_rate", true, [](const State& s) { return static_cast<double>(kinematics(s).b); }, has_rates},
      {"attitude_rate", true, attitude_rate_of, in_motion_only},
      {"ex", true, [](const State& s) { return s.ex; }, in_plane_only},
      {"ey", true, [](const State& s) { return s.ey; }, in_plane_only},
      {"speed", false, [](const State& s) { return std::hypot(s.vx, s.vy); }, in_plane_only},
      {"eccentricity_ratio", false, ratio_of, anywhere},
      {"one_minus_eccentricity_ratio", false,
       [](const State& s) {
         return given_in_polar(s) ? 1 - s.eccentricity_ratio : static_cast<double>(kinematics(s).ratio_gap);
       },
       anywhere}};
  return list;
}

bool Condition::holds_for(double value) const {
  switch (comparator) {
    case Comparator::less:
      return value < threshold;
    case Comparator::less_or_equal:
      return value <= threshold;
    case Comparator::equal:
      return value == threshold;
    case Comparator::not_equal:
      return value != threshold;
    case Comparator::greater_or_equal:
      return value >= threshold;
    case Comparator::greater:
      break;
  }
  return value > threshold;
}

std::string Condition::words() const {
  return fmt::format("{} {} {}", feature->name, comparator_words[static_cast<std::size_t>(comparator)], threshold);
}

bool holds(const Conjunction& conditions, const State& state) {
  return std::ranges::all_of(conditions, [&](const Condition& c) { return c.holds(state); });
}

std::string words(const Conjunction& conditions) {
  std::string text;
  for (const Condition& c : conditions) text += (text.empty() ? "" : " and ") + c.words();
  return text;
}

std::string words(const Domain& domain) {
  std::string text;
  for (const Conjunction& each : domain) text += (text.empty() ? "" : ", or where ") + words(each);
  return text;
}

Conjunction read_conditions(Quantities quantities, std::string_view text) {
  std::string names;
  for (const Feature& feature : features()) {
    if (is_declared(feature, quantities)) names += (names.empty() ? "" : ", ") + std::string(feature.name);
  }
  const std::string allowed =
      "; allowed are conditions NAME OP NUMBER with commas between them, OP one of < <= == != >= >, NAME one of " +
      names;
  Conjunction list;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::string_view part = trimmed(text.substr(0, comma));
    const auto refuse = [&] {
      throw std::invalid_argument("the condition \"" + std::string(part) + "\" can't be read" + allowed);
    };
    const std::size_t begin = part.find_first_of("<>=!");
    const std::size_t end = begin == std::string_view::npos ? begin : part.find_first_not_of("<>=!", begin);
    if (end == std::string_view::npos) refuse();
    const std::string_view name = trimmed(part.substr(0, begin)), number = trimmed(part.substr(end));
    const auto comparator = std::ranges::find(comparator_words, part.substr(begin, end - begin));
    const auto feature = std::ranges::find_if(
        features(), [&](const Feature& f) { return f.name == name && is_declared(f, quantities); });
    double threshold = 0;
    const auto [last, error] = std::from_chars(number.data(), number.data() + number.size(), threshold);
    const bool is_number = error == std::errc() && last == number.data() + number.size() && std::isfinite(threshold);
    if (comparator == comparator_words.end() || feature == features().end() || !is_number) refuse();
    list.push_back({&*feature, static_cast<Comparator>(comparator - comparator_words.begin()), threshold});
    if (comma == std::string_view::npos) return list;
    text.remove_prefix(comma + 1);
  }
}

Conjunction steady_conditions(Quantities quantities) {
  if (quantities == Quantities::contact) {
    throw std::invalid_argument("steady does nothing with the quantities contact: nothing turns");
  }
  if (is_of_load(quantities)) {
    throw std::invalid_argument("steady does nothing with the quantities " + std::string(name_of(quantities)) +
                                ": every state is");
  }
  return read_conditions(
      quantities, is_polar(quantities) ? "squeeze_rate == 0, attitude_rate == 0" : "speed == 0, omega_bearing == 0");
}

Domain domain_of(Quantities quantities, const std::vector<State>& states, const std::vector<int>& in_set) {
  return DomainSearch(quantities, states, in_set).result();
}

}  // namespace lubjoint::verify
