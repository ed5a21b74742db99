/// Texts of errors.
#pragma once

#include <charconv>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>

namespace lubjoint {

/// A text in the making whose doubles stand in as few digits as say them: a number that was typed looks as it was.
/// Longer numbers stand in 17 digits.
class Message {
 public:
  Message() { text_.precision(17); }
  /// Appends a part.
  template <class Part>
  Message& operator<<(const Part& part) {
    if constexpr (std::is_same_v<Part, double> || std::is_same_v<Part, float>) {
      char digits[32];
      text_ << std::string_view(digits,
                                static_cast<std::size_t>(std::to_chars(digits, digits + 32, part).ptr - digits));
    } else {
      text_ << part;
    }
    return *this;
  }
  std::string str() const { return text_.str(); }  ///< all of it

 private:
  std::ostringstream text_;
};

}  // namespace lubjoint
