#include "oracle/verify/c/lubjoint_verify.h"

#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "lib/c/guarded.hpp"
#include "lubjoint/film/compiled_laws.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/reynolds/film_onset.hpp"
#include "oracle/verify/report.hpp"
#include "oracle/verify/states/finite_film.hpp"
#include "oracle/verify/states/solved_film_states.hpp"
#include "oracle/verify/verification.hpp"

namespace {

using namespace lubjoint::verify;

using lubjoint::c::copied;

thread_local lubjoint::c::LastMessage message;

template <class Work>
int guarded(const Work& work) noexcept {
  return lubjoint::c::guarded(message, work);
}

Quantities named(const char* quantities) {
  if (quantities == nullptr) throw std::invalid_argument("quantities is a null pointer");
  return quantities_of(quantities);
}

/// The domain that is declared.
Conjunction declared(const lubjoint_verify_request* request) {
  const Quantities kind = named(request->quantities);
  Conjunction domain;
  if (request->only != nullptr) domain = read_conditions(kind, request->only);
  if (request->steady == 0) return domain;
  for (const Condition& condition : steady_conditions(kind)) domain.push_back(condition);
  return domain;
}

/// The film of finite length that is claimed, if it is one.
std::optional<FiniteClaim> finite_claim(const lubjoint_verify_request* request) {
  const std::string_view law = request->law != nullptr ? request->law : "auto";
  const auto onset = request->onset != nullptr ? std::optional<std::string>(request->onset) : std::nullopt;
  const lubjoint::oracle::FilmOnset begin = lubjoint::oracle::film_onset_of(law, onset, "onset");  // refuses
  if (!lubjoint::is_compiled_law(law)) return std::nullopt;
  return FiniteClaim{lubjoint::oracle::finite_film_of(law), begin};
}

std::vector<State> asked(const lubjoint_verify_request* request) {
  if (request == nullptr) throw std::invalid_argument("request is a null pointer");
  const Quantities kind = named(request->quantities);
  if (request->shear != nullptr && kind != Quantities::losses) {
    throw std::invalid_argument("shear does nothing with the quantities " + std::string(name_of(kind)) +
                                "; allowed is it with losses");
  }
  const lubjoint::ShearExtent shear = lubjoint::shear_extent(request->shear ? request->shear : "film");
  std::vector<State> states;
  if (const auto claim = finite_claim(request)) {
    states = is_finite_force(kind)
                 ? finite_states(kind, declared(request))
                 : solved_film_states(*claim, kind, declared(request), shear, lubjoint::reports::available_cores());
  } else {
    if (request->golden == nullptr) throw std::invalid_argument("golden is a null pointer");
    if (request->law != nullptr) require_law(kind, request->law);
    states = states_to_verify(kind, request->golden, request->random, request->seed, declared(request));
    for (State& state : states) {
      state.shear = shear;
      if (shear != lubjoint::ShearExtent::film) state.golden.reset();  // certified are the films' own losses
    }
  }
  return request->at_most > 0 ? covering_states(kind, std::move(states), request->at_most) : states;
}

/// What a judge says, for those who ask.
template <class Result>
void report(const Result& result, int* verdict, char** text, char** json) {
  const std::string words = text ? text_report(result) : std::string();
  const std::string object = json ? json_report(result).dump() : std::string();
  char* const words_copy = text ? copied(words) : nullptr;
  try {
    if (json) *json = copied(object);
  } catch (...) {
    std::free(words_copy);
    throw;
  }
  if (text) *text = words_copy;
  *verdict = result.accepted() ? 0 : result.verdict == Verdict::undecided ? 2 : 1;
}

template <class Names>
const char* joined(std::map<Quantities, std::string>& kept, const char* quantities, const Names& names) noexcept {
  const char* result = nullptr;
  guarded([&] {
    const Quantities kind = named(quantities);
    std::string& text = kept[kind];
    if (text.empty()) {
      for (const std::string_view name : names(kind)) text.append(text.empty() ? "" : ",").append(name);
    }
    result = text.c_str();
  });
  return result;
}

}  // namespace

const char* lubjoint_verify_message(void) { return message.text(); }

const char* lubjoint_verify_state_columns(const char* quantities) {
  thread_local std::map<Quantities, std::string> kept;
  return joined(kept, quantities, [](Quantities kind) {
    std::vector<std::string_view> names;
    for (const StateColumn& column : state_columns(kind)) names.push_back(column.name);
    return names;
  });
}

const char* lubjoint_verify_answer_columns(const char* quantities) {
  thread_local std::map<Quantities, std::string> kept;
  return joined(kept, quantities, [](Quantities kind) { return answer_columns(kind); });
}

int lubjoint_verify_count(const lubjoint_verify_request* request, size_t* count) {
  return guarded([&] {
    if (count == nullptr) throw std::invalid_argument("count is a null pointer");
    *count = asked(request).size();
  });
}

int lubjoint_verify_states(const lubjoint_verify_request* request, double* out) {
  return guarded([&] {
    if (out == nullptr) throw std::invalid_argument("out is a null pointer");
    const std::vector<State> states = asked(request);
    for (const StateColumn& column : state_columns(named(request->quantities))) {
      for (const State& state : states) *out++ = state.*column.value;
    }
  });
}

int lubjoint_verify_judge(const lubjoint_verify_request* request, const double* answers, double tolerance, double unit,
                          int* verdict, char** text, char** json) {
  return guarded([&] {
    if (answers == nullptr) throw std::invalid_argument("answers is a null pointer");
    if (verdict == nullptr) throw std::invalid_argument("verdict is a null pointer");
    if (!(tolerance >= 0 && tolerance <= 0.1)) {
      throw std::invalid_argument("tolerance is " + std::to_string(tolerance) + "; allowed is a number from 0 to 0.1");
    }
    std::vector<State> states = asked(request);
    const Quantities kind = named(request->quantities);
    if (!(unit > 0) || !std::isfinite(unit) || (unit != 1 && kind != Quantities::dimensionless)) {
      throw std::invalid_argument(
          "unit is " + std::to_string(unit) +
          "; allowed is a number above 0, other than 1 with the quantities dimensionless alone");
    }
    const std::size_t columns = answer_columns(kind).size();
    std::vector<Answer> values(states.size(), Answer{});
    for (std::size_t k = 0; k < columns; ++k) {
      for (Answer& value : values) value[k] = *answers++;
    }
    Answers given = answers_from_numbers(kind, std::move(values));
    scale(given, unit);
    const std::string domain = words(declared(request));
    const auto claim = finite_claim(request);
    if (claim && is_finite_force(kind)) {
      report(verify_finite_film(*claim, kind, std::move(states), std::move(given), tolerance,
                                lubjoint::reports::available_cores(), domain),
             verdict, text, json);
    } else {
      report(verify_answers(kind, request->law != nullptr ? request->law : "auto", std::move(states), std::move(given),
                            {claim && tolerance == 0 ? finite_tolerance : tolerance, domain}),
             verdict, text, json);
    }
  });
}

void lubjoint_verify_free(char* report) { std::free(report); }
