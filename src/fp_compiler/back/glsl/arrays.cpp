#include "fp_compiler/back/glsl/arrays.h"

#include <algorithm>

#include "fp_compiler/back/glsl/number.h"
#include "fp_compiler/back/glsl/state.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::glsl {

using ir::Instruction;
using ir::ParameterKind;

namespace {
bool readsRow(const Instruction &instruction, int operand) {
  return instruction.src[std::size_t(operand)].relative &&
         ir::registerMask(instruction, operand) != 0;
}

/// True if GLSL has a built-in variable for the row.
bool isBuiltIn(const ir::Parameter &row) {
  return row.kind == ParameterKind::State && stateText(row.state).has_value();
}

std::string rowText(const ir::Parameter &row) {
  if (row.kind == ParameterKind::State)
    return stateText(row.state)->text;
  std::string text = "vec4(";
  for (std::size_t i = 0; i < 4; ++i)
    text += (i ? ", " : "") + number(row.constant[i]);
  return text + ")";
}

std::string nameOf(std::size_t index) { return "arb_array" + std::to_string(index); }

std::string bracket(const std::string &index) { return "[" + index + "]"; }

/// Returns the rows of one array, in order.
std::vector<const ir::Parameter *> rowsOf(const ir::Program &program, std::size_t index) {
  std::vector<const ir::Parameter *> rows;
  for (const std::uint16_t row : program.arrays[index].rows)
    rows.push_back(&program.parameters[row]);
  return rows;
}
} // namespace

void hoistRelative(ir::Program &program) {
  std::vector<Instruction> code;
  code.reserve(program.code.size());
  const std::size_t first = program.temporaries.size();
  std::size_t added = 0;
  for (Instruction instruction : program.code) {
    std::size_t slot = 0;
    for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i) {
      ir::Operand &operand = instruction.src[std::size_t(i)];
      if (!operand.relative)
        continue;
      if (!readsRow(instruction, i)) { // an operand of only 0 and 1 reads no row
        operand.relative = false;
        operand.index = 0;
        continue;
      }
      Instruction fetch;
      fetch.dst.index = std::uint16_t(first + slot);
      fetch.dst.mask = ir::registerMask(instruction, i);
      fetch.src[0] = operand;
      fetch.src[0].swizzle = ir::kIdentity;
      fetch.src[0].negate = 0;
      code.push_back(fetch);
      operand.file = ir::File::Temporary;
      operand.index = fetch.dst.index;
      operand.relative = false;
      added = std::max(added, ++slot);
    }
    code.push_back(instruction);
  }
  program.temporaries.resize(first + added);
  program.code = std::move(code);
}

Arrays::Arrays(const ir::Program &program, const std::string &uniformArray,
               std::vector<GlslUniform> &uniforms) {
  std::vector<bool> used(program.arrays.size(), false);
  for (const Instruction &instruction : program.code)
    for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i)
      if (readsRow(instruction, i))
        used[instruction.src[std::size_t(i)].index] = true;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i])
      declare(program, i, uniformArray, uniforms);
}

void Arrays::declare(const ir::Program &program, std::size_t index, const std::string &uniformArray,
                     std::vector<GlslUniform> &uniforms) {
  const auto rows = rowsOf(program, index);
  const std::string name = nameOf(index);
  const std::string size = std::to_string(rows.size());
  const bool constant = std::all_of(rows.begin(), rows.end(), [](const ir::Parameter *row) {
    return row->kind == ParameterKind::Constant;
  });
  const bool mixed = std::any_of(rows.begin(), rows.end(),
                                 [](const ir::Parameter *row) { return isBuiltIn(*row); });
  std::string element = name + "_rows[i]";
  if (constant) {
    m_functions += "const vec4 " + name + "_rows" + bracket(size) + " = vec4" + bracket(size) + "(";
    for (std::size_t i = 0; i < rows.size(); ++i)
      m_functions += (i ? ", " : "") + rowText(*rows[i]);
    m_functions += ");\n";
  } else if (mixed) {
    m_functions += "vec4 " + name + "_rows" + bracket(size) + ";\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
      std::string value;
      if (rows[i]->kind == ParameterKind::Constant || isBuiltIn(*rows[i])) {
        value = rowText(*rows[i]);
      } else {
        value = uniformArray + bracket(std::to_string(uniforms.size()));
        uniforms.push_back({*rows[i]});
      }
      m_locals += "  " + name + "_rows" + bracket(std::to_string(i)) + " = " + value + ";\n";
    }
  } else {
    const std::size_t base = uniforms.size();
    element = uniformArray + bracket(base == 0 ? "i" : std::to_string(base) + " + i");
    for (const ir::Parameter *row : rows)
      uniforms.push_back({*row});
  }
  m_functions += "vec4 " + name + "(int i) { return i >= 0 && i < " + size + " ? " + element +
                 " : vec4(0.0); }\n";
}

std::string Arrays::element(const ir::Operand &operand) {
  std::string row = "a" + std::to_string(operand.address);
  if (operand.offset != 0)
    row += (operand.offset > 0 ? " + " : " - ") + std::to_string(std::abs(int(operand.offset)));
  return nameOf(operand.index) + "(" + row + ")";
}

} // namespace arbiter::fp::glsl
