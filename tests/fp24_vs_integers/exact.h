#pragma once
#include <array>
#include <cstdint>

namespace arbiter::fp::proof {

/// A number without error: a sign, and a magnitude as an integer multiple of 2^-192 below 2^192. It
/// holds every 24-bit float, every product of two, and sums of a few of them. It shares nothing
/// with the tested code: it uses no float arithmetic and no bits of an IEEE single.
class Exact {
public:
  Exact() = default;
  /// Makes \p mantissa * 2^\p exponent. Requires that it fits.
  Exact(bool negative, std::uint64_t mantissa, int exponent);

  [[nodiscard]] bool isZero() const;
  [[nodiscard]] bool negative() const { return m_negative; }
  Exact operator-() const;
  Exact operator+(const Exact &other) const;

  /// Returns the nearest number with \p bits significant bits, a tie to the even one; the exponent
  /// is unbounded. Requires bits <= 53, so that a double holds it.
  [[nodiscard]] double rounded(int bits) const;

private:
  static constexpr int kWords = 12;
  using Words = std::array<std::uint32_t, kWords>;
  static constexpr int kUnit = -192;

  [[nodiscard]] bool below(const Exact &other) const; ///< compares magnitudes
  [[nodiscard]] int topBit() const;
  [[nodiscard]] bool bit(int index) const;

  bool m_negative = false;
  Words m_words = {}; ///< least significant first
};

/// The parts of a finite double: value = mantissa * 2^exponent, with 53 bits unless it is 0.
struct Parts {
  bool negative = false;
  std::uint64_t mantissa = 0;
  int exponent = 0;
};
[[nodiscard]] Parts partsOf(double value);

/// These take two finite singles within the range of Exact.
[[nodiscard]] Exact exactSum(float a, float b);
[[nodiscard]] Exact exactProduct(float a, float b);
/// These results have infinitely many digits. They are exact in the first 40 bits and in whether
/// any digit follows, so that they round to 24 bits like the true quotient and root. Requires 0 <
/// numerator, denominator < 2^17; value is a normal 24-bit float above zero.
[[nodiscard]] Exact exactQuotient(std::uint32_t numerator, std::uint32_t denominator, int exponent);
[[nodiscard]] Exact exactReciprocal(float value);
[[nodiscard]] Exact exactReciprocalRoot(float value);

} // namespace arbiter::fp::proof
