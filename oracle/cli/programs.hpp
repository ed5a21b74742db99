/// Which program has which command: none waits for what another one needs.
#pragma once

#include <array>
#include <string_view>

namespace lubjoint::cli {

/// A command, the file name of the program that has it, and what it does. `lubjoint` itself runs that program; the
/// script of the checkout reads here which one to build.
struct ProgramCommand {
  std::string_view command;
  std::string_view program;
  std::string_view words;
};

inline constexpr std::array<ProgramCommand, 22> program_commands = {{
    {"reproduce", "lubjoint-paper", "The paper's examples with every law, checked; report.html"},
    {"simulate", "lubjoint-scenes", "Run one scene: trajectory as CSV, and a summary"},
    {"assemble", "lubjoint-scenes",
     "Places and velocities that close a scene's loops, from rough guesses: the scene anew on standard output"},
    {"periodic", "lubjoint-scenes",
     "A start from which a scene's motion repeats, by shooting: the scene anew on standard output"},
    {"force", "lubjoint-scenes", "Film force of a law at given states, CSV in and out"},
    {"losses", "lubjoint-scenes", "Friction torques, power and side flow of a film at given motions, CSV in and out"},
    {"mobility", "lubjoint-scenes",
     "Pure-squeeze velocities at which a film carries given forces, CSV in and out: the inverse of force"},
    {"equilibrium", "lubjoint-scenes", "Steady state of a journal, its stiffness, damping and eigenvalues"},
    {"coefficients", "lubjoint-scenes",
     "Stiffness, damping, critical mass and whirl ratio of a journal at rest on its film, as CSV"},
    {"stability", "lubjoint-scenes", "Critical mass and speed of a rigid rotor on its film, and maps of its stability"},
    {"compile-film", "lubjoint-scenes", "Table of a finite-length law, with its measured error"},
    {"oracle", "lubjoint-paper", "Forces and pressures that do not come from the force laws"},
    {"model-error", "lubjoint-paper", "Each law against the film of finite length, for a scene's or a given bearing"},
    {"benchmark", "lubjoint-scenes",
     "Mechanisms that others have published: difference from their numbers, run time, energy drift;\nexit 1 if any "
     "disagrees"},
    {"accuracy", "lubjoint-paper", "Rounding errors of every law by eccentricity ratio, against 100 digits"},
    {"bench", "lubjoint-measure", "Error against run time: laws, quadrature rules, finite-length films, scenes"},
    {"cost", "lubjoint-measure", "What a scene pays for in a right-hand side, and what it leaves out"},
    {"sweep", "lubjoint-scenes", "A scene at every combination of some values: one row each"},
    {"stress", "lubjoint-measure", "Numerical stability: extreme cases x laws x integrators; exit 1 if any is wrong"},
    {"golden", "lubjoint-golden", "Regenerate the certified golden data, or compare with it"},
    {"verify", "lubjoint-verify", "Is another implementation right, and if not, what is its mistake?"},
    {"prove", "lubjoint-prove", "The proof ledger: formulas proved symbolically, mistakes refuted"},
}};

/// What a command does; does not compile for one that no program has.
consteval const char* words_of(std::string_view command) {
  for (const ProgramCommand& each : program_commands) {
    if (each.command == command) return each.words.data();
  }
  throw "no program has it";
}

}  // namespace lubjoint::cli
