#include "apps/tools/debug/trace/compare.h"

#include <algorithm>
#include <cmath>

#include "apps/tools/debug/trace/numbers.h"

namespace arbiter::tools::debug {

namespace {

/// If the product of the lengths is larger, rows are paired by their numbers to limit memory.
constexpr std::size_t kMaxCells = 1 << 22;

bool isAlike(const Row &a, const Row &b) {
  if (a.op != b.op || a.mask != b.mask || a.texel.has_value() != b.texel.has_value())
    return false;
  return !a.texel || (a.texel->unit == b.texel->unit && a.texel->target == b.texel->target);
}

/// Finds the longest common sequence of a[from, aEnd) and b[from, bEnd) by dynamic programming.
class CommonSequence {
public:
  CommonSequence(const Trace &a, const Trace &b, std::size_t from, std::size_t aEnd,
                 std::size_t bEnd)
      : m_a(a), m_b(b), m_from(from), m_rows(aEnd - from), m_columns(bEnd - from),
        m_lengths((m_rows + 1) * (m_columns + 1), 0) {
    for (std::size_t i = m_rows; i-- > 0;)
      for (std::size_t j = m_columns; j-- > 0;)
        at(i, j) = alike(i, j) ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
  }

  void append(Pairs &pairs) {
    for (std::size_t i = 0, j = 0; i < m_rows && j < m_columns;)
      if (alike(i, j)) {
        pairs.emplace_back(m_from + i++, m_from + j++);
      } else if (at(i + 1, j) >= at(i, j + 1)) {
        ++i;
      } else {
        ++j;
      }
  }

private:
  bool alike(std::size_t i, std::size_t j) const {
    return isAlike(m_a.rows[m_from + i], m_b.rows[m_from + j]);
  }
  std::uint32_t &at(std::size_t i, std::size_t j) { return m_lengths[i * (m_columns + 1) + j]; }

  const Trace &m_a, &m_b;
  std::size_t m_from, m_rows, m_columns;
  std::vector<std::uint32_t> m_lengths;
};

/// Adds pairs of the rows between the members, in order.
Pairs filled(const Pairs &members, std::size_t aEnd, std::size_t bEnd) {
  Pairs pairs;
  std::size_t i = 0, j = 0;
  const auto fill = [&](std::size_t toA, std::size_t toB) {
    while (i < toA && j < toB)
      pairs.emplace_back(i++, j++);
    i = toA;
    j = toB;
  };
  for (const auto &[a, b] : members) {
    fill(a, b);
    fill(a + 1, b + 1);
  }
  fill(aEnd, bEnd);
  return pairs;
}

std::string causeOf(const Row &a, const Row &b, const Tolerance &tolerance) {
  if (a.op != b.op)
    return "the instruction is another: " + b.text;
  for (std::size_t i = 0; i < a.operands.size() && i < b.operands.size(); ++i) {
    const Operand &mine = a.operands[i], &other = b.operands[i];
    if (!differing(mine.value.first, other.value.first, mine.reads & other.reads, tolerance))
      continue;
    const std::string name =
        mine.text == other.text ? mine.text : mine.text + " (" + other.text + " there)";
    return "operand " + std::to_string(i + 1) + ", " + name + ": " +
           vectorText(mine.value.first, mine.reads) + " here, " +
           vectorText(other.value.first, other.reads) + " there";
  }
  if (a.texel && b.texel)
    return "the texels differ";
  return {};
}

const Named *find(const std::vector<Named> &all, const std::string &name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named &each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

} // namespace

bool isEqual(float a, float b, const Tolerance &tolerance) {
  if (a == b || (std::isnan(a) && std::isnan(b)))
    return true;
  if (!std::isfinite(a) || !std::isfinite(b))
    return false;
  const float most = std::max(std::fabs(a), std::fabs(b));
  return std::fabs(a - b) <= std::max(tolerance.absolute, tolerance.relative * most);
}

std::uint8_t differing(const Vec4 &a, const Vec4 &b, std::uint8_t mask,
                       const Tolerance &tolerance) {
  std::uint8_t components = 0;
  for (std::size_t c = 0; c < 4; ++c)
    if ((mask >> c & 1) && !isEqual(a[c], b[c], tolerance))
      components |= std::uint8_t(1 << c);
  return components;
}

Pairs align(const Trace &a, const Trace &b) {
  std::size_t from = 0, aEnd = a.rows.size(), bEnd = b.rows.size();
  while (from < aEnd && from < bEnd && isAlike(a.rows[from], b.rows[from]))
    ++from;
  while (aEnd > from && bEnd > from && isAlike(a.rows[aEnd - 1], b.rows[bEnd - 1])) {
    --aEnd;
    --bEnd;
  }
  Pairs members;
  for (std::size_t i = 0; i < from; ++i)
    members.emplace_back(i, i);
  if ((aEnd - from + 1) <= kMaxCells / (bEnd - from + 1))
    CommonSequence(a, b, from, aEnd, bEnd).append(members);
  for (std::size_t i = 0; i < a.rows.size() - aEnd; ++i)
    members.emplace_back(aEnd + i, bEnd + i);
  return filled(members, a.rows.size(), b.rows.size());
}

std::optional<Difference> firstDifference(const Trace &a, const Trace &b,
                                          const Tolerance &tolerance) {
  for (const auto &[i, j] : align(a, b)) {
    const Row &mine = a.rows[i], &other = b.rows[j];
    Difference difference{i, j, {mine.value.first, other.value.first}, 0, {}};
    difference.components =
        differing(mine.value.first, other.value.first, mine.mask & other.mask, tolerance);
    if (difference.components == 0 && mine.discards.first == other.discards.first)
      continue;
    difference.cause = causeOf(mine, other, tolerance);
    return difference;
  }
  return {};
}

std::optional<std::string> differingResult(const Trace &a, const Trace &b,
                                           const Tolerance &tolerance) {
  for (const Named &mine : a.results) {
    const Named *const other = find(b.results, mine.name);
    if (!other ||
        differing(mine.value.first, other->value.first, mine.mask | other->mask, tolerance))
      return mine.name;
  }
  for (const Named &other : b.results)
    if (!find(a.results, other.name))
      return other.name;
  return {};
}

} // namespace arbiter::tools::debug
