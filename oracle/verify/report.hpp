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

/// Terms and domains, as reports of every kind have them.
std::string terms_text(const std::vector<Term>& terms);
std::string domains_text(const Domain& right, const Domain& wrong, const Domain& not_a_number);
nlohmann::json terms_json(const std::vector<Term>& terms);
nlohmann::json domain_json(const Domain& domain);

/// The sentence of the verdict.
std::string headline(const Verification& verification);

}  // namespace lubjoint::verify
