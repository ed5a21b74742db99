#include "oracle/certified/digits.hpp"

#include <stdexcept>

namespace lubjoint::certified {

namespace {

constexpr slong first_bits = 192;
constexpr slong last_bits = 12288;

/// Sign, digits and decimal exponent of the first digit.
struct Decimal {
  bool negative = false;
  std::string digits;
  long exponent = 0;

  std::string text() const {
    std::string result = negative ? "-" : "";
    result += digits[0];
    if (digits.size() > 1) result += "." + digits.substr(1);
    return result + "e" + std::to_string(exponent);
  }
};

/// The midpoint rounded to 30 digits. FLINT chooses between 12.3 and 1.23e1; here it is always the latter.
Decimal midpoint_digits(const Ball& ball) {
  Ball midpoint;
  arb_get_mid_arb(midpoint.get(), ball.get());
  char* raw = arb_get_str(midpoint.get(), printed_digits, ARB_STR_NO_RADIUS | ARB_STR_MORE);
  std::string text(raw);
  flint_free(raw);
  Decimal decimal;
  decimal.negative = text.starts_with('-');
  if (decimal.negative) text.erase(0, 1);
  const std::size_t e = text.find('e');
  if (e != std::string::npos) {
    decimal.exponent = std::stol(text.substr(e + 1));
    text.resize(e);
  }
  const std::size_t point = std::min(text.find('.'), text.size());
  decimal.exponent += static_cast<long>(point) - 1;
  if (point < text.size()) text.erase(point, 1);
  const std::size_t first = text.find_first_not_of('0');
  decimal.exponent -= static_cast<long>(first);
  decimal.digits = text.substr(first, printed_digits);
  return decimal;
}

/// Is the decimal number within so many hundredths of a unit of its 30th digit from all of the ball?
bool within(const Decimal& decimal, const Ball& ball, int hundredths) {
  const slong bits = 2 * arb_bits(ball.get()) + 512;
  const WorkingPrecision exact(bits);
  Ball printed;
  arb_set_str(printed.get(), decimal.text().c_str(), bits);
  Ball bound;
  const std::string unit = std::to_string(hundredths) + "e" + std::to_string(decimal.exponent - printed_digits - 1);
  arb_set_str(bound.get(), unit.c_str(), bits);
  const Ball excess = bound - abs(printed - ball);
  return arb_is_nonnegative(excess.get()) != 0;
}

/// Is the decimal number the ball, which then has no radius?
bool is_exactly(const Decimal& decimal, const Ball& ball) {
  if (!arb_is_exact(ball.get())) return false;
  Ball printed;
  arb_set_str(printed.get(), decimal.text().c_str(), 2 * arb_bits(ball.get()) + 4096);
  return arb_is_exact(printed.get()) && arb_equal(printed.get(), ball.get());
}

bool determines_its_digits(const Ball& ball) {
  return ball.is_exact_zero() || arb_rel_accuracy_bits(ball.get()) >= required_bits;
}

CertifiedNumber print(const Ball& ball) {
  if (ball.is_exact_zero()) return {"0", "0"};
  Decimal decimal = midpoint_digits(ball);
  if (is_exactly(decimal, ball)) {
    decimal.digits.erase(decimal.digits.find_last_not_of('0') + 1);
    return {decimal.text(), "0"};
  }
  decimal.digits.resize(printed_digits, '0');
  if (!within(decimal, ball, 51)) throw std::logic_error("digits that the ball does not guarantee: " + decimal.text());
  return {decimal.text(), "5.1e" + std::to_string(decimal.exponent - printed_digits)};
}

}  // namespace

std::vector<CertifiedNumber> certify(const std::function<std::vector<Ball>()>& evaluate) {
  for (slong bits = first_bits; bits <= last_bits; bits *= 2) {
    const WorkingPrecision precision(bits);
    std::vector<Ball> balls;
    try {
      balls = evaluate();
    } catch (const Undecided&) {
      continue;
    }
    bool enough = true;
    for (const Ball& ball : balls) enough = enough && determines_its_digits(ball);
    if (!enough) continue;
    std::vector<CertifiedNumber> numbers;
    for (const Ball& ball : balls) numbers.push_back(print(ball));
    return numbers;
  }
  throw std::runtime_error("a ball that does not determine 30 digits with 12288 bits");
}

}  // namespace lubjoint::certified
