// Runs a scene through code that was compiled with a call at the entry of every function, and prints which were
// entered: entered_functions SCENE.toml. Linked before the scene library, this code takes the place of the library's.
#include <cxxabi.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"

namespace {
constexpr std::size_t places = 1 << 14;
std::array<void*, places> entered{};  // open addressing
bool recording = false;
}  // namespace

extern "C" {
// Instrumented code calls these; they must not be instrumented themselves.
__attribute__((no_instrument_function)) void __cyg_profile_func_enter(void* function, void*) {
  if (!recording) return;
  std::size_t at = (reinterpret_cast<std::size_t>(function) >> 4) % places;
  for (std::size_t i = 0; i < places && entered[at] != function; ++i) {
    if (entered[at] == nullptr) entered[at] = function;
    if (entered[at] != function) at = (at + 1) % places;
  }
}
__attribute__((no_instrument_function)) void __cyg_profile_func_exit(void*, void*) {}
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const lubjoint::Scene scene = lubjoint::load_scene(argv[1]);
  recording = true;
  const lubjoint::MultibodyTrajectory run = lubjoint::simulate_multibody(scene);
  recording = false;
  std::set<std::string> names;
  for (void* function : entered) {
    Dl_info info{};
    if (function == nullptr || ::dladdr(function, &info) == 0 || info.dli_sname == nullptr) continue;
    int status = 0;
    char* name = abi::__cxa_demangle(info.dli_sname, nullptr, nullptr, &status);
    names.insert(status == 0 ? name : info.dli_sname);
    std::free(name);
  }
  for (const std::string& name : names) std::printf("%s\n", name.c_str());
  return run.outcome.status == lubjoint::RunStatus::finished ? 0 : 1;
}
