#include "oracle/certified/overlap.hpp"

#include <stdexcept>

namespace lubjoint::certified {

void require_overlap(const std::function<std::vector<Ball>()>& closed_form,
                     const std::function<std::vector<Ball>()>& quadrature, const std::string& where) {
  constexpr slong relative = 80;
  for (slong bits = 128; bits <= 2048; bits += bits / 2) {
    const WorkingPrecision precision(bits);
    const std::vector<Ball> first = closed_form();
    const std::vector<Ball> second = quadrature();
    Ball squares(0);
    for (const Ball& component : first) squares = squares + component * component;
    Ball allowed = sqrt(squares);
    if (!arb_is_finite(allowed.get()) || arb_contains_negative(allowed.get())) continue;
    arb_mul_2exp_si(allowed.get(), allowed.get(), -relative);
    bool narrow = true;
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (!first[i].overlaps(second[i])) throw std::logic_error("closed form and quadrature do not overlap: " + where);
      Ball radius;
      arb_get_rad_arb(radius.get(), second[i].get());
      narrow = narrow && (arb_is_finite(second[i].get()) != 0) && (arb_le(radius.get(), allowed.get()) != 0);
    }
    if (narrow) return;
  }
  throw std::logic_error("quadrature does not become narrow: " + where);
}

}  // namespace lubjoint::certified
