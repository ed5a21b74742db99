/// What `verify` prints besides its reports.
#pragma once

#include <string>

namespace lubjoint::cli {

/// An adapter for a program of one's own. @throws std::invalid_argument that lists the languages there are
std::string verify_template(const std::string& language);

/// What programs are given and have to answer, and what is right at a journal in the centre.
std::string described_quantities();

}  // namespace lubjoint::cli
