#include "state/programs/variants/attribute_forms.h"

#include "fp_compiler/ir/reads.h"
#include "state/mirror/attribute_aliases.h"

namespace arbiter::state {

namespace {

using fp::ir::Attribute;
using fp::ir::AttributeKind;
using fp::ir::File;
using fp::ir::Instruction;
using fp::ir::Operand;
using fp::ir::Program;
using fp::ir::Select;

/// Returns the components that the attribute's conventional commands set; all four if there is no
/// difference to the generic one.
std::uint8_t conventionalMask(const Attribute &attribute) {
  switch (attribute.kind) {
  case AttributeKind::Normal:
  case AttributeKind::ColorSecondary:
    return 0x7;
  case AttributeKind::FogCoord:
    return 0x1;
  default:
    return 0xF;
  }
}

/// Returns the conventional attribute of a register. Requires isAliasedRegister(number).
Attribute conventionalOf(unsigned number) {
  switch (number) {
  case 2:
    return {AttributeKind::Normal, 0};
  case 3:
    return {AttributeKind::ColorPrimary, 0};
  case 4:
    return {AttributeKind::ColorSecondary, 0};
  case 5:
    return {AttributeKind::FogCoord, 0};
  default:
    return {AttributeKind::TexCoord, std::uint8_t(number - 8)};
  }
}

bool isSet(std::uint32_t mask, unsigned number) { return (mask >> number & 1u) != 0; }

Operand read(File file, std::size_t index, Select component) {
  Operand operand{.file = file, .index = std::uint16_t(index)};
  operand.swizzle.fill(component);
  return operand;
}

Operand read(File file, std::size_t index) { return {.file = file, .index = std::uint16_t(index)}; }

std::uint16_t addTemporary(Program &program) {
  program.temporaries.push_back({"v"});
  return std::uint16_t(program.temporaries.size() - 1);
}

/// Appends code that leaves the attribute's value in a temporary, and returns the temporary. SEQ
/// and MIN test whether all common components are equal; a NaN counts as unequal.
std::uint16_t choose(Program &program, std::size_t attribute, std::vector<Instruction> &code) {
  const std::uint8_t mask = conventionalMask(program.attributes[attribute]);
  const std::size_t generic = program.attributes.size();
  program.attributes.push_back(
      {AttributeKind::Generic, std::uint8_t(genericNumberOf(program.attributes[attribute]))});
  const std::uint16_t equal = addTemporary(program);
  const std::uint16_t value = addTemporary(program);
  const auto write = [&](fp::ir::Opcode op, std::uint16_t to, std::uint8_t components, Operand a,
                         Operand b, Operand c = {}) {
    code.push_back({.op = op, .dst = fp::ir::Destination{.index = to, .mask = components}});
    code.back().src = {a, b, c};
  };
  write(fp::ir::Opcode::Seq, equal, mask, read(File::Attribute, attribute),
        read(File::Attribute, generic));
  for (const Select other : {Select::Y, Select::Z})
    if ((mask >> int(other) & 1u) != 0)
      write(fp::ir::Opcode::Min, equal, 1, read(File::Temporary, equal, Select::X),
            read(File::Temporary, equal, other));
  Operand notEqual = read(File::Temporary, equal, Select::X);
  notEqual.negate = 0xF;
  write(fp::ir::Opcode::Cmp, value, 0xF, notEqual, read(File::Attribute, generic),
        read(File::Attribute, attribute));
  return value;
}

} // namespace

std::shared_ptr<const Program> withConventionalAttributes(const Program &program) {
  std::shared_ptr<Program> form;
  for (std::size_t i = 0; i < program.attributes.size(); ++i) {
    const Attribute &attribute = program.attributes[i];
    if (attribute.kind != AttributeKind::Generic || !isAliasedRegister(attribute.index))
      continue;
    if (!form)
      form = std::make_shared<Program>(program);
    form->attributes[i] = conventionalOf(attribute.index);
  }
  return form;
}

std::uint32_t registersOf(const Program &program) {
  std::uint32_t numbers = 0;
  for (const Attribute &attribute : program.attributes)
    numbers |= 1u << genericNumberOf(attribute);
  return numbers & kAliasedRegisters;
}

std::uint32_t readsBeyondConventional(const Program &program) {
  std::uint32_t numbers = 0;
  for (const Instruction &instruction : program.code)
    for (int i = 0; i < fp::ir::info(instruction.op).operandCount(); ++i) {
      const Operand &operand = instruction.src[std::size_t(i)];
      if (operand.file != File::Attribute)
        continue;
      const Attribute &attribute = program.attributes[operand.index];
      if ((fp::ir::registerMask(instruction, i) & ~conventionalMask(attribute)) != 0)
        numbers |= 1u << genericNumberOf(attribute);
    }
  return numbers;
}

std::shared_ptr<const Program> withAttributes(const Program &program, std::uint32_t generic,
                                              std::uint32_t either) {
  auto form = std::make_shared<Program>(program);
  std::vector<Instruction> before;
  for (std::size_t i = 0; i < program.attributes.size(); ++i) {
    const unsigned number = genericNumberOf(program.attributes[i]);
    if (isSet(generic, number)) {
      form->attributes[i] = {AttributeKind::Generic, std::uint8_t(number)};
    } else if (isSet(either, number)) {
      const std::uint16_t value = choose(*form, i, before);
      for (Instruction &instruction : form->code)
        for (Operand &operand : instruction.src)
          if (operand.file == File::Attribute && operand.index == i) {
            operand.file = File::Temporary;
            operand.index = value;
          }
    }
  }
  if (!before.empty() && form->options.nv == fp::ir::NvOption::None)
    form->options.nv = fp::ir::NvOption::First; // choose() uses opcodes of this option
  form->code.insert(form->code.begin(), before.begin(), before.end());
  return form;
}

} // namespace arbiter::state
