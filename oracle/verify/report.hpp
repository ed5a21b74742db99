/// What a user is told about an implementation.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "oracle/verify/verification.hpp"

namespace lubjoint::verify {

std::string text_report(const Verification& verification);
nlohmann::json json_report(const Verification& verification);

/// "agrees", "agrees_to_digits", "disagrees", "undecided": the word that scripts read.
std::string_view verdict_name(Verdict verdict);

/// The sentence of the verdict.
std::string headline(const Verification& verification);

}  // namespace lubjoint::verify
