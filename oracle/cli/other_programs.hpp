/// Commands that are programs of their own: what one command needs, another does not wait for.
#pragma once

#include <array>
#include <string_view>

namespace lubjoint::cli {

/// A command of another program, beside this one.
struct OtherProgram {
  std::string_view command;
  std::string_view words;    ///< what it does
  std::string_view program;  ///< file name
};

inline constexpr std::array<OtherProgram, 6> other_programs = {{
    {"bench", "Error against run time: laws, quadrature rules, finite-length films, scenes", "lubjoint-measure"},
    {"cost", "What a scene pays for in a right-hand side, and what it leaves out", "lubjoint-measure"},
    {"stress", "Numerical stability: extreme cases x laws x integrators; exit 1 if any is wrong", "lubjoint-measure"},
    {"golden", "Regenerate the certified golden data, or compare with it", "lubjoint-golden"},
    {"verify", "Is another implementation right, and if not, what is its mistake?", "lubjoint-verify"},
    {"prove", "The proof ledger: formulas proved symbolically, mistakes refuted", "lubjoint-prove"},
}};

/// What a command that has a program of its own does; does not compile for one that has none.
consteval const char* words_of(std::string_view command) {
  for (const OtherProgram& each : other_programs) {
    if (each.command == command) return each.words.data();
  }
  throw "no program of its own";
}

}  // namespace lubjoint::cli
