#include "fp_compiler/ir/builder.h"

#include <algorithm>
#include <cassert>
#include <string>

namespace arbiter::fp::ir {

namespace {
Select letter(char c) {
  constexpr std::string_view kLetters = "xyzw01";
  const std::size_t at = kLetters.find(c);
  assert(at != std::string_view::npos);
  return Select(at);
}

Source source(File file, std::size_t index) {
  Source result;
  result.file = file;
  result.index = std::uint16_t(index);
  return result;
}

Target target(File file, std::size_t index) {
  Target result;
  result.file = file;
  result.index = std::uint16_t(index);
  return result;
}
} // namespace

Source Source::swz(std::string_view letters) const {
  assert(letters.size() == 1 || letters.size() == 4);
  Source result = *this;
  result.negate = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Select select = letter(letters.size() == 1 ? letters[0] : letters[i]);
    if (select > Select::W) {
      result.swizzle[i] = select;
      continue;
    }
    result.swizzle[i] = swizzle[std::size_t(select)];
    if (negate >> int(select) & 1)
      result.negate |= std::uint8_t(1 << i);
  }
  return result;
}

Source Source::operator-() const { return negated(0xF); }

Source Source::negated(std::uint8_t mask) const {
  Source result = *this;
  result.negate ^= mask;
  return result;
}

Target Target::mask(std::string_view letters) const {
  Target result = *this;
  result.Destination::mask = 0;
  for (const char c : letters)
    result.Destination::mask |= std::uint8_t(1 << int(letter(c)));
  return result;
}

Target Target::sat() const {
  Target result = *this;
  result.saturate = true;
  return result;
}

Source Target::read() const { return source(file, index); }

Target Builder::temporary(std::string_view name) {
  const std::size_t index = m_program.temporaries.size();
  m_program.temporaries.push_back({name.empty() ? "t" + std::to_string(index) : std::string(name)});
  return target(File::Temporary, index);
}

Target Builder::output(Output wanted) {
  auto &outputs = m_program.outputs;
  const auto found = std::find(outputs.begin(), outputs.end(), wanted);
  const std::size_t index = std::size_t(found - outputs.begin());
  if (found == outputs.end())
    outputs.push_back(wanted);
  return target(File::Output, index);
}

Target Builder::result(OutputKind kind, int index) { return output({kind, std::uint8_t(index)}); }
Target Builder::color(int index) { return output({OutputKind::Color, std::uint8_t(index)}); }
Target Builder::depth() { return output({OutputKind::Depth, 0}); }

Target Builder::address() {
  const std::size_t index = m_program.addresses.size();
  m_program.addresses.push_back({"a" + std::to_string(index)});
  return target(File::Address, index).mask("x");
}

int Builder::array(const std::vector<Source> &rows) {
  ParameterArray wanted{"array" + std::to_string(m_program.arrays.size()), {}};
  for (const Source &row : rows) {
    assert(row.file == File::Parameter && !row.relative);
    wanted.rows.push_back(row.index);
  }
  m_program.arrays.push_back(std::move(wanted));
  return int(m_program.arrays.size()) - 1;
}

Source Builder::element(int array, const Target &address, int offset) {
  assert(address.file == File::Address);
  Source result = source(File::Parameter, std::size_t(array));
  result.relative = true;
  result.address = std::uint8_t(address.index);
  result.offset = std::int16_t(offset);
  return result;
}

Source Builder::attribute(AttributeKind kind, int index) {
  const Attribute wanted{kind, std::uint8_t(index)};
  auto &attributes = m_program.attributes;
  const auto found = std::find(attributes.begin(), attributes.end(), wanted);
  const std::size_t at = std::size_t(found - attributes.begin());
  if (found == attributes.end())
    attributes.push_back(wanted);
  return source(File::Attribute, at);
}

Source Builder::parameter(Parameter wanted) {
  m_program.parameters.push_back(wanted);
  return source(File::Parameter, m_program.parameters.size() - 1);
}

Source Builder::constant(float x, float y, float z, float w) {
  Parameter wanted;
  wanted.constant = {x, y, z, w};
  return parameter(wanted);
}

Source Builder::env(int index) {
  Parameter wanted;
  wanted.kind = ParameterKind::Env;
  wanted.index = std::uint16_t(index);
  return parameter(wanted);
}

Source Builder::local(int index) {
  Parameter wanted;
  wanted.kind = ParameterKind::Local;
  wanted.index = std::uint16_t(index);
  return parameter(wanted);
}

Source Builder::state(const StateRef &ref) {
  Parameter wanted;
  wanted.kind = ParameterKind::State;
  wanted.state = ref;
  return parameter(wanted);
}

Builder &Builder::op(Opcode opcode, const Target &dst, std::initializer_list<Source> sources) {
  assert(int(sources.size()) == info(opcode).operandCount());
  Instruction instruction;
  instruction.op = opcode;
  instruction.dst = dst;
  std::copy(sources.begin(), sources.end(), instruction.src.begin());
  m_program.code.push_back(instruction);
  return *this;
}

Builder &Builder::tex(Opcode opcode, const Target &dst, const Source &coordinate, int unit,
                      TexTarget texTarget) {
  op(opcode, dst, {coordinate});
  m_program.code.back().unit = std::uint8_t(unit);
  m_program.code.back().target = texTarget;
  return *this;
}

void Builder::setSpan(std::size_t first, Span span) {
  for (std::size_t i = first; i < m_program.code.size(); ++i)
    m_program.code[i].span = span;
}

Builder &Builder::kil(const Source &killed) { return op(Opcode::Kil, Target{}, {killed}); }

} // namespace arbiter::fp::ir
