#include "oracle/page/packed_numbers.hpp"

#include <bit>
#include <cmath>
#include <string_view>

namespace lubjoint::reports::page {

void PackedNumbers::int8(double value) {
  add(static_cast<std::uint8_t>(static_cast<std::int8_t>(std::lround(value))), 1);
}

void PackedNumbers::int16(double value) {
  add(static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(value))), 2);
}

void PackedNumbers::float32(double value) { add(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4); }

void PackedNumbers::add(std::uint32_t bits, int count) {
  for (int i = 0; i < count; ++i) bytes_ += static_cast<char>(bits >> 8 * i & 0xffU);
}

std::string PackedNumbers::base64() const {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes_.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes_.size() ? static_cast<unsigned char>(bytes_[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes_.size() ? letters[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

}  // namespace lubjoint::reports::page
