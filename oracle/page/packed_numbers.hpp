/// Numbers of an animation's frames as the page carries them, and which samples become frames.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace lubjoint::reports::page {

/// Numbers as little-endian bytes, one after the other; player.js reads them.
class PackedNumbers {
 public:
  /// A whole number from -127 to 127, rounded.
  void int8(double value);
  /// A whole number from -32767 to 32767, rounded.
  void int16(double value);
  /// In single precision.
  void float32(double value);
  /// All of them as text.
  std::string base64() const;

 private:
  void add(std::uint32_t bits, int count);
  std::string bytes_;
};

/// Samples evenly apart: the first of every `stride`, at most `frames` + 1 of them but for a remainder.
/// @param samples  at least one
inline std::size_t stride_for(std::size_t samples, std::size_t frames) {
  return std::max<std::size_t>(1, (samples - 1) / frames);
}

}  // namespace lubjoint::reports::page
