/// Each force law against the pressure that it claims to integrate, and against its published formula in 100 digits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "oracle/laws/accuracy.hpp"
#include "oracle/laws/pinkus_sternlicht_difference.hpp"
#include "oracle/results/check.hpp"

namespace lubjoint::reports {

/// Differences of one law at random states of the film, over |F|.
struct LawCheck {
  std::string law;
  std::size_t states = 0;
  /// To the quadrature of the law's pressure: none for a law that is the integral of no pressure.
  struct Quadrature {
    double median = 0;
    double largest = 0;
    double eccentricity_ratio_of_largest = 0;
  };
  std::optional<Quadrature> quadrature;
  double rounding = 0;  ///< largest difference to 100 digits, ε up to 1 − 1e-6
  double allowed = 0;   ///< of both
  Verdict verdict() const;
  bool agrees() const { return verdict().agrees(); }
};

/// What the checks draw their states from.
struct LawCheckSettings {
  std::size_t states = 2000;    ///< of the quadrature, a law
  std::size_t directions = 24;  ///< of the 100 digits, at each ε, beside axes and diagonals
  std::uint64_t seed = 1;       ///< of both
};

struct LawChecks {
  LawCheckSettings settings;
  std::vector<LawCheck> laws;
  std::vector<AccuracyRow> rounding;  ///< against 100 digits, by ε
  /// Pinkus–Sternlicht is an approximation: its distance from the long dynamic film, ε uniform up to 0.97.
  DifferenceSummary closing;
  DifferenceSummary opening;
  bool passed() const;
};

/// Checks all laws. Half of the quadrature's states have ε uniform on 0…1, half have 1 − ε log-uniform from 1 to 1e-6;
/// directions of u are uniform, |u| log-uniform over six decades.
LawChecks check_laws(const LawCheckSettings& settings);

std::string law_check_table(const LawChecks& checks);

}  // namespace lubjoint::reports
