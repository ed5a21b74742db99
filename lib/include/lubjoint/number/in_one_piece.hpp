/// Small formulas that are compiled together.
#pragma once

#include <concepts>

namespace lubjoint {

/// Calls f. On plain numbers R, all that it calls is compiled into one piece with it, which leaves out what nobody
/// reads: rates where places are asked for. Numbers of many digits are no part of this: their code would fill the
/// memory.
template <class R, class F>
void in_one_piece(const F& f) {
  f();
}
/// Likewise.
template <std::floating_point R, class F>
[[gnu::flatten]] void in_one_piece(const F& f) {
  f();
}

}  // namespace lubjoint
