#include <algorithm>
#include <array>
#include <cmath>

#include "apps/tools/advise/rules/rules.h"
#include "fp_compiler/ir/reads.h"

/// Finds weighted sums of one vector's components that are computed step by step, and proposes a
/// dot product.
namespace arbiter::tools::advise {

namespace {

/// A sum of one register's weighted components and a constant.
struct Sum {
  std::optional<std::pair<std::uint32_t, int>> place; ///< an operand that names the register
  fp::ir::Vec4 weights = {};
  std::array<bool, 4> has = {};
  float number = 0.0f;
  std::uint32_t first = 0; ///< the sum's first instruction
};

class Summing {
public:
  Summing(const Subject &subject, std::uint32_t last) : m_subject(subject), m_last(last) {
    m_sum.first = last;
  }

  /// Adds the result of a scalar instruction, times a weight. False if it has another form.
  bool add(std::uint32_t index, std::size_t position, float weight, int depth = 0) {
    const Instruction &instruction = m_subject.at(index);
    if (depth > 6 || (instruction.dst.saturate && index != m_last))
      return false;
    m_sum.first = std::min(m_sum.first, index);
    switch (instruction.op) {
    case Opcode::Add:
      return operand(index, 0, position, weight, depth) &&
             operand(index, 1, position, weight, depth);
    case Opcode::Sub:
      return operand(index, 0, position, weight, depth) &&
             operand(index, 1, position, -weight, depth);
    case Opcode::Mul:
      return product(index, position, weight, depth);
    case Opcode::Mad:
      return product(index, position, weight, depth) && operand(index, 2, position, weight, depth);
    default:
      return false;
    }
  }

  [[nodiscard]] const Sum &sum() const { return m_sum; }

private:
  bool product(std::uint32_t index, std::size_t position, float weight, int depth) {
    for (const int o : {0, 1})
      if (const auto factor = m_subject.number(index, o, int(position)))
        return operand(index, 1 - o, position, weight * *factor, depth);
    return false;
  }

  bool operand(std::uint32_t index, int o, std::size_t position, float weight, int depth) {
    if (const auto number = m_subject.number(index, o, int(position))) {
      m_sum.number += weight * *number;
      return true;
    }
    const Operand &source = m_subject.at(index).src[std::size_t(o)];
    const fp::ir::Select select = source.swizzle[position];
    if (select > fp::ir::Select::W || source.relative)
      return false;
    const float sign = source.negate >> position & 1 ? -1.0f : 1.0f;
    const auto writer = m_subject.flow().writer(index, o);
    if (writer && m_subject.flow().onlyUse(*writer) &&
        add(*writer, std::size_t(select), sign * weight, depth + 1))
      return true;
    return term(index, o, std::size_t(select), sign * weight);
  }

  bool term(std::uint32_t index, int o, std::size_t component, float weight) {
    const Operand &source = m_subject.at(index).src[std::size_t(o)];
    if (m_sum.place) {
      const Operand &other = m_subject.at(m_sum.place->first).src[std::size_t(m_sum.place->second)];
      if (other.file != source.file || other.index != source.index)
        return false;
    }
    // The register must keep its value until the last instruction.
    Operand all = source;
    all.swizzle = fp::ir::kIdentity;
    if (!m_subject.flow().holds(all, 0xF, index, m_last))
      return false;
    m_sum.place = {index, o};
    m_sum.weights[component] += weight;
    m_sum.has[component] = true;
    return true;
  }

  const Subject &m_subject;
  std::uint32_t m_last;
  Sum m_sum;
};

/// Returns the dot product's opcode and its constant vector.
std::optional<std::pair<Opcode, fp::ir::Vec4>> productOf(const Sum &sum) {
  fp::ir::Vec4 numbers = sum.weights;
  const int terms = int(sum.has[0]) + sum.has[1] + sum.has[2] + sum.has[3];
  if (!sum.place || terms < 2 || !std::isfinite(sum.number))
    return std::nullopt;
  if (sum.number == 0.0f)
    return std::pair(sum.has[3] ? Opcode::Dp4 : Opcode::Dp3, numbers);
  if (sum.has[3])
    return std::nullopt;
  numbers[3] = sum.number;
  return std::pair(Opcode::Dph, numbers);
}

} // namespace

Proposals dotProducts(const Subject &subject) {
  Proposals proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i) {
    const Instruction &instruction = subject.at(i);
    if (!subject.flow().live(i) || fp::ir::writeMask(instruction) == 0 ||
        (instruction.dst.mask & (instruction.dst.mask - 1)) != 0)
      continue;
    std::size_t position = 0;
    while (!(instruction.dst.mask >> position & 1))
      ++position;
    Summing summing(subject, i);
    if (!summing.add(i, position, 1.0f))
      continue;
    const auto product = productOf(summing.sum());
    if (!product)
      continue;
    const auto [op, numbers] = *product;
    const std::string base = subject.base(summing.sum().place->first, summing.sum().place->second);
    Draft draft(subject);
    draft.replace(i, statementText(op, instruction.dst.saturate, subject.destination(i),
                                   {base, vectorText(numbers)}));
    proposals.push_back(draft.about(summing.sum().first, i, "sum_by_dot_product",
                                    std::string("a sum of one register's components is one ") +
                                        fp::ir::info(op).mnemonic,
                                    Nearness::Rounding));
  }
  return proposals;
}

} // namespace arbiter::tools::advise
