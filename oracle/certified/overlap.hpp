/// Two independent enclosures of one number must overlap.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracle/certified/ball.hpp"

namespace lubjoint::certified {

/// Evaluates both at more and more bits until the second's balls are all narrower than 2^(−80) of the length of the
/// first as a vector (24 digits), and compares them component by component.
/// @param where  names the state in the message
/// @throws std::logic_error if two balls do not overlap, or if thousands of bits do not make them narrow
void require_overlap(const std::function<std::vector<Ball>()>& closed_form,
                     const std::function<std::vector<Ball>()>& quadrature, const std::string& where);

}  // namespace lubjoint::certified
