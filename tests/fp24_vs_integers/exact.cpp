#include "exact.h"

#include <cassert>
#include <cmath>
#include <compare>

namespace arbiter::fp::proof {

Exact::Exact(bool negative, std::uint64_t mantissa, int exponent) : m_negative(negative) {
  for (; mantissa != 0 && (mantissa & 1) == 0; mantissa >>= 1)
    ++exponent;
  const int shift = exponent - kUnit;
  assert(mantissa == 0 || (shift >= 0 && shift + 64 < kWords * 32));
  for (int i = 0; i < 64; ++i)
    if (mantissa >> i & 1)
      m_words[std::size_t((i + shift) / 32)] |= 1u << (i + shift) % 32;
}

bool Exact::isZero() const { return topBit() < 0; }

Exact Exact::operator-() const {
  Exact result = *this;
  result.m_negative = !m_negative;
  return result;
}

bool Exact::below(const Exact &other) const {
  for (std::size_t i = kWords; i-- > 0;)
    if (m_words[i] != other.m_words[i])
      return m_words[i] < other.m_words[i];
  return false;
}

Exact Exact::operator+(const Exact &other) const {
  const bool swapped = below(other);
  const Exact &large = swapped ? other : *this;
  const Exact &small = swapped ? *this : other;
  const bool subtract = m_negative != other.m_negative;
  Exact result = large;
  std::int64_t carry = 0;
  for (std::size_t i = 0; i < kWords; ++i) {
    const std::int64_t addend = small.m_words[i];
    const std::int64_t word =
        std::int64_t(large.m_words[i]) + (subtract ? -addend : addend) + carry;
    result.m_words[i] = std::uint32_t(word & 0xFFFFFFFF);
    carry = word >> 32;
  }
  assert(carry == 0);
  return result;
}

int Exact::topBit() const {
  for (int i = kWords; i-- > 0;)
    if (m_words[std::size_t(i)] != 0) {
      int bit = 31;
      while (!(m_words[std::size_t(i)] >> bit & 1))
        --bit;
      return i * 32 + bit;
    }
  return -1;
}

bool Exact::bit(int index) const {
  return index >= 0 && (m_words[std::size_t(index / 32)] >> index % 32 & 1);
}

double Exact::rounded(int bits) const {
  const int top = topBit();
  if (top < 0)
    return 0.0;
  const int last = top - bits + 1; // the lowest bit that stays
  std::uint64_t kept = 0;
  for (int i = top; i >= last; --i)
    kept = kept << 1 | (bit(i) ? 1u : 0u);
  bool sticky = false;
  for (int i = 0; i < last - 1; ++i)
    sticky = sticky || bit(i);
  if (bit(last - 1) && (sticky || (kept & 1)))
    ++kept;
  const double size = std::ldexp(double(kept), last + kUnit);
  return m_negative ? -size : size;
}

Parts partsOf(double value) {
  Parts result;
  result.negative = std::signbit(value);
  const double fraction = std::frexp(std::fabs(value), &result.exponent);
  result.mantissa = std::uint64_t(std::ldexp(fraction, 53));
  result.exponent -= 53;
  return result;
}

Exact exactSum(float a, float b) {
  const Parts p = partsOf(double(a)), q = partsOf(double(b));
  return Exact(p.negative, p.mantissa, p.exponent) + Exact(q.negative, q.mantissa, q.exponent);
}

Exact exactProduct(float a, float b) {
  const Parts p = partsOf(double(a)), q = partsOf(double(b));
  // A single has 24 significant bits: the lower ones of the 53 are zero.
  return {p.negative != q.negative, (p.mantissa >> 29) * (q.mantissa >> 29),
          p.exponent + q.exponent + 58};
}

Exact exactQuotient(std::uint32_t numerator, std::uint32_t denominator, int exponent) {
  const std::uint64_t dividend = std::uint64_t(numerator) << 46;
  const std::uint64_t quotient = dividend / denominator;
  const std::uint64_t more = dividend % denominator != 0;
  return {false, quotient << 1 | more, exponent - 47};
}

Exact exactReciprocal(float value) {
  const Parts p = partsOf(double(value));
  const std::uint64_t dividend = std::uint64_t(1) << 62, divisor = p.mantissa >> 36;
  return {false, dividend / divisor << 1 | (dividend % divisor != 0), -63 - (p.exponent + 36)};
}

namespace {
/// A 128-bit number, a type that not every compiler has.
struct Wide {
  std::uint64_t high, low;
  auto operator<=>(const Wide &) const = default;
};

Wide squareOf(std::uint64_t value) {
  const std::uint64_t low = value & 0xFFFFFFFF, high = value >> 32;
  const std::uint64_t middle = low * high + (low * low >> 32); // below 2^64: (2^32-1)^2 + 2^32-1
  const std::uint64_t more = (middle & 0xFFFFFFFF) + low * high;
  return {high * high + (middle >> 32) + (more >> 32), more << 32 | (low * low & 0xFFFFFFFF)};
}

/// Computes 2^120 / divisor, rounded down, for a divisor below 2^32. \param whole set to whether
/// the quotient is exact
Wide quotientOf120(std::uint64_t divisor, bool &whole) {
  std::uint64_t digits[4] = {std::uint64_t(1) << 24, 0, 0, 0}, rest = 0;
  for (std::uint64_t &digit : digits) {
    const std::uint64_t part = rest << 32 | digit;
    digit = part / divisor;
    rest = part % divisor;
  }
  whole = rest == 0;
  return {digits[0] << 32 | digits[1], digits[2] << 32 | digits[3]};
}
} // namespace

Exact exactReciprocalRoot(float value) {
  const Parts p = partsOf(double(value));
  const int exponent = p.exponent + 36;
  const int odd = exponent & 1;
  const auto mantissa = (p.mantissa >> 36) << odd; // value = mantissa * 2^(exponent - odd)
  // The loop finds the largest root with root^2 * mantissa <= 2^120, digit by digit.
  bool whole = false;
  const Wide limit = quotientOf120(mantissa, whole);
  std::uint64_t root = 0;
  for (std::uint64_t digit = std::uint64_t(1) << 53; digit != 0; digit >>= 1)
    if (squareOf(root | digit) <= limit)
      root |= digit;
  const bool more = !whole || squareOf(root) != limit;
  return {false, root << 1 | more, -61 - (exponent - odd) / 2};
}

} // namespace arbiter::fp::proof
