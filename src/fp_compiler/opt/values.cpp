#include "fp_compiler/opt/values.h"

#include <bit>

#include "fp_compiler/ir/reads.h"
#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::opt {

namespace {
constexpr std::size_t kMaxRows = 0xFFFF; // an operand's index has 16 bits

std::array<std::uint32_t, 4> bitsOf(const ir::Vec4 &value) {
  return std::bit_cast<std::array<std::uint32_t, 4>>(value);
}
} // namespace

std::optional<float> constantAt(const ir::Program &program, const Operand &operand, int position,
                                Numerics numerics) {
  const Select select = operand.swizzle[std::size_t(position)];
  float value = 0.0f;
  if (select == Select::One) {
    value = 1.0f;
  } else if (select != Select::Zero) {
    if (operand.file != ir::File::Parameter || operand.relative)
      return {};
    const ir::Parameter &parameter = program.parameters[operand.index];
    if (parameter.kind != ir::ParameterKind::Constant)
      return {};
    const float given = parameter.constant[std::size_t(select)];
    const Numerics mode = ir::numericsOf(program.language, numerics);
    // NVIDIA's MOV would copy the bits of a denormal, which arithmetic reads as zero.
    if (program.options.nv != ir::NvOption::None && mode != Numerics::Fp24 &&
        ir::flushed(given) != given)
      return {};
    value = ir::loaded(given, mode);
  }
  return operand.negate >> position & 1 ? -value : value;
}

std::optional<float> uniformConstant(const ir::Program &program, const Operand &operand,
                                     std::uint8_t mask, Numerics numerics) {
  std::optional<float> result;
  for (int i = 0; i < 4; ++i) {
    if (!(mask >> i & 1))
      continue;
    const std::optional<float> value = constantAt(program, operand, i, numerics);
    if (!value)
      return {};
    if (result && std::bit_cast<std::uint32_t>(*result) != std::bit_cast<std::uint32_t>(*value))
      return {};
    result = value;
  }
  return result;
}

bool sameRegister(const Operand &a, const Operand &b) {
  if (a.file != b.file || a.index != b.index || a.relative != b.relative)
    return false;
  return !a.relative || (a.address == b.address && a.offset == b.offset);
}

bool sameReads(const Operand &a, const Operand &b, std::uint8_t mask) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(mask >> i & 1))
      continue;
    if (a.swizzle[i] != b.swizzle[i] || (a.negate >> i & 1) != (b.negate >> i & 1))
      return false;
    if (a.swizzle[i] <= Select::W && !sameRegister(a, b))
      return false;
  }
  return true;
}

void fillUnused(Operand &operand, std::uint8_t mask) {
  const int first = std::countr_zero(mask);
  for (int i = 0; i < 4; ++i) {
    if (mask >> i & 1)
      continue;
    operand.swizzle[std::size_t(i)] = operand.swizzle[std::size_t(first)];
    const int sign = operand.negate >> first & 1;
    operand.negate = std::uint8_t((operand.negate & ~(1 << i)) | sign << i);
  }
}

void Versions::write(const ir::Instruction &instruction) {
  const std::uint8_t mask = ir::writeMask(instruction);
  if (mask != 0 && instruction.dst.file == ir::File::Address)
    ++m_addresses[instruction.dst.index];
  if (mask == 0 || instruction.dst.file != ir::File::Temporary)
    return;
  for (std::size_t i = 0; i < 4; ++i)
    if (mask >> i & 1)
      ++m_versions[instruction.dst.index][i];
}

std::size_t ConstantRows::Hash::operator()(const std::array<std::uint32_t, 4> &bits) const {
  std::size_t hash = 0;
  for (const std::uint32_t word : bits)
    hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
  return hash;
}

ConstantRows::ConstantRows(ir::Program &program) : m_program(program) {
  for (std::size_t i = 0; i < program.parameters.size(); ++i)
    if (program.parameters[i].kind == ir::ParameterKind::Constant)
      m_rows.emplace(bitsOf(program.parameters[i].constant), std::uint16_t(i));
}

bool ConstantRows::hasRoom() const { return m_program.parameters.size() < kMaxRows; }

Operand ConstantRows::operand(const ir::Vec4 &value, const Span &span) {
  const auto [row, added] =
      m_rows.emplace(bitsOf(value), std::uint16_t(m_program.parameters.size()));
  if (added) {
    ir::Parameter parameter;
    parameter.constant = value;
    m_program.parameters.push_back(parameter);
  }
  Operand result;
  result.file = ir::File::Parameter;
  result.index = row->second;
  result.span = span;
  return result;
}

} // namespace arbiter::fp::opt
