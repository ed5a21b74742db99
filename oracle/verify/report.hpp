/// What a user is told about an implementation.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oracle/verify/diagnosis.hpp"

namespace lubjoint::verify {

enum class Verdict { agrees, disagrees, unjudged };

/// The whole result of a verification.
struct Verification {
  Judgement judgement;
  std::vector<State> states;
  Answers answers;
  std::optional<Diagnosis> diagnosis;  ///< where the answers disagree
  bool law_was_found = false;          ///< by --law auto

  Verdict verdict() const;
};

/// Judges answers against a law, or against every law for "auto": the first that agrees, or else the one whose
/// mistakes explain most.
/// @throws std::invalid_argument for a law that is not there
Verification verify_answers(Quantities quantities, const std::string& law, std::vector<State> states, Answers answers);

std::string text_report(const Verification& verification);
nlohmann::json json_report(const Verification& verification);

}  // namespace lubjoint::verify
