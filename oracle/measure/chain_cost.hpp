/// How the cost of one right-hand side grows with the number of bodies.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace lubjoint::reports {

/// A chain of n pendulums: times of one right-hand side, and of what an implicit integrator adds [ns].
struct ChainCost {
  std::size_t bodies;
  std::size_t constraint_rows;
  std::size_t schur_stored;
  double rhs;
  double factorisation;  ///< of it: assembly and factorisation of the Schur complement
  double solve;          ///< of it: multipliers and accelerations
  double jacobian;       ///< the exact Jacobian of the equations of motion
  double implicit_step;  ///< one step of radau_iia5, Jacobian and factorisations included
};

/// n from 1 to 1000.
/// @param rounds  of which medians are taken; a tenth, at least 3, of what takes milliseconds
std::vector<ChainCost> chain_cost(std::size_t rounds);

/// Slope of log t over log n from n = 50 on, by least squares.
double growth_exponent(const std::vector<ChainCost>& rows, double ChainCost::*time);

nlohmann::ordered_json chain_json(const std::vector<ChainCost>& rows);
std::string chain_text(const std::vector<ChainCost>& rows);

}  // namespace lubjoint::reports
