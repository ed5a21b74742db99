#include "oracle/c/lubjoint_simulate.h"

#include <limits>

#include "lib/c/guarded.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/laws/film_store.hpp"
#include "oracle/laws/scene_run.hpp"

using namespace lubjoint;

struct lubjoint_simulation {
  reports::RunOfScene run;
  std::string summary;
};

namespace {

thread_local c::LastMessage message;

template <class T>
std::optional<T> given(const T* number) {
  return number == nullptr ? std::nullopt : std::optional<T>(*number);
}

std::optional<std::string> given(const char* text) {
  return text == nullptr ? std::nullopt : std::optional<std::string>(text);
}

SceneFile file_of(const lubjoint_simulate_request& request) {
  if ((request.file == nullptr) == (request.text == nullptr)) {
    throw std::invalid_argument("required is one of a scene file and a scene's text");
  }
  return request.file != nullptr ? SceneFile(request.file) : SceneFile(request.text, "text");
}

}  // namespace

const char* lubjoint_simulate_message(void) { return message.text(); }

int lubjoint_simulate(const lubjoint_simulate_request* request, lubjoint_simulation** run) {
  return c::guarded(message, [&] {
    c::require("request", request);
    c::require("run", run);
    std::vector<std::string> notes;
    reports::SceneFilms films([&](const std::string& law, double shape) {
      reports::CompilerOptions options{reports::available_cores(), {}};
      if (request->progress != nullptr) options.progress = request->progress;
      const std::string shipped = given(request->films).value_or("");
      return reports::film_at_hand(law, shape, reports::user_film_store(shipped), options,
                                   [&notes](const std::string& note) { notes.push_back("warning: " + note); });
    });
    const reports::SceneSettings settings{given(request->law), given(request->integrator), given(request->rtol),
                                          given(request->duration), ""};
    const reports::SceneToRun scene = reports::scene_to_run(file_of(*request), settings, films);
    const reports::LateChoice late{given(request->after), request->last_revolution != 0, {"after", "last_revolution"}};
    lubjoint_simulation result{reports::run_of_scene(scene, late), {}};
    result.summary = result.run.summary.dump();
    result.run.warnings.insert(result.run.warnings.begin(), notes.begin(), notes.end());
    *run = new lubjoint_simulation(std::move(result));
  });
}

size_t lubjoint_simulation_rows(const lubjoint_simulation* run) { return run->run.table.rows.size(); }

size_t lubjoint_simulation_columns(const lubjoint_simulation* run) { return run->run.table.columns.size(); }

const char* lubjoint_simulation_column(const lubjoint_simulation* run, size_t i) {
  const auto& columns = run->run.table.columns;
  return i < columns.size() ? columns[i].c_str() : nullptr;
}

void lubjoint_simulation_values(const lubjoint_simulation* run, double* out) {
  const TrajectoryTable& table = run->run.table;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    for (const auto& row : table.rows) *out++ = row[k].value_or(std::numeric_limits<double>::quiet_NaN());
  }
}

int lubjoint_simulation_finished(const lubjoint_simulation* run) { return run->run.finished ? 1 : 0; }

const char* lubjoint_simulation_summary(const lubjoint_simulation* run) { return run->summary.c_str(); }

const char* lubjoint_simulation_warning(const lubjoint_simulation* run, size_t i) {
  return i < run->run.warnings.size() ? run->run.warnings[i].c_str() : nullptr;
}

void lubjoint_simulation_free(lubjoint_simulation* run) { delete run; }
