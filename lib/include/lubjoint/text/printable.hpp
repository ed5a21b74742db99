/// Text of an unknown source, made fit for a message.
#pragma once

#include <string>
#include <string_view>

namespace lubjoint {

/// One line without control characters, whatever the text holds: "\n", "\x00"… are written out, so that no message is
/// cut short, split, or read as a command by a terminal.
inline std::string printable(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '\n') {
      line += "\\n";
    } else if (code < 0x20 || code == 0x7f) {
      constexpr std::string_view digits = "0123456789abcdef";
      line += std::string("\\x") + digits[code / 16] + digits[code % 16];
    } else {
      line += c;
    }
  }
  return line;
}

}  // namespace lubjoint
