/// Templates, styles and scripts of this folder, carried by the program.
#pragma once

#include <string_view>

namespace lubjoint::reports::page {

/// The text of a file of this folder, as it was when the program was built.
/// @throws std::logic_error for a file that the build does not carry
std::string_view resource(std::string_view file_name);

/// Revision of the checkout that the program was built from; empty if it was not known.
std::string_view revision();

}  // namespace lubjoint::reports::page
