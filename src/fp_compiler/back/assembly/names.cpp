#include "fp_compiler/back/assembly/names.h"

#include <algorithm>
#include <charconv>

#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::assembly {

using ir::File;

namespace {
std::string numbered(const char *prefix, std::size_t index) {
  return prefix + std::to_string(index);
}

std::string bindingOf(const ir::Parameter &row) {
  if (row.kind != ir::ParameterKind::Constant)
    return ir::bindingText(row);
  std::string text = "{";
  for (std::size_t i = 0; i < 4; ++i)
    text += (i ? ", " : "") + numeral(row.constant[i]);
  return text + "}";
}

/// Returns the number of rows from \p first on that are consecutive env or local parameters.
std::size_t runLength(const ir::Program &program, const std::vector<std::uint16_t> &rows,
                      std::size_t first) {
  const ir::Parameter &begin = program.parameters[rows[first]];
  if (begin.kind != ir::ParameterKind::Env && begin.kind != ir::ParameterKind::Local)
    return 1;
  std::size_t length = 1;
  for (; first + length < rows.size(); ++length) {
    const ir::Parameter &next = program.parameters[rows[first + length]];
    if (next.kind != begin.kind || next.index != begin.index + length)
      break;
  }
  return length;
}

/// Returns the bindings of an array's rows. Consecutive rows become a range, which a host can load
/// faster.
std::string bindingsOf(const ir::Program &program, const std::vector<std::uint16_t> &rows) {
  std::string text;
  for (std::size_t row = 0; row < rows.size();) {
    const ir::Parameter &parameter = program.parameters[rows[row]];
    const std::size_t length = runLength(program, rows, row);
    std::string binding = bindingOf(parameter);
    if (length > 1)
      binding.insert(binding.size() - 1, ".." + std::to_string(parameter.index + length - 1));
    text += (text.empty() ? "" : ", ") + binding;
    row += length;
  }
  return text;
}

/// Returns a declaration of the used registers: "TEMP t0, t1;
/// ".
std::string list(const char *statement, const char *prefix, const std::vector<bool> &used) {
  std::string text;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i])
      text += (text.empty() ? "" : ", ") + numbered(prefix, i);
  return text.empty() ? "" : std::string(statement) + " " + text + ";\n";
}
} // namespace

std::string numeral(float value) {
  char digits[64];
  // The output must not depend on the application's locale.
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  return std::string(digits, end.ptr);
}

Names::Names(const ir::Program &program)
    : m_program(program), m_temporaries(program.temporaries.size()),
      m_parameters(program.parameters.size()), m_addresses(program.addresses.size()),
      m_arrays(program.arrays.size()), m_elements(program.parameters.size()) {
  for (const ir::Instruction &instruction : program.code) {
    for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i)
      use(instruction.src[std::size_t(i)]);
    if (ir::writeMask(instruction) == 0)
      continue;
    if (instruction.dst.file == File::Temporary)
      m_temporaries[instruction.dst.index] = true;
    if (instruction.dst.file == File::Address)
      m_addresses[instruction.dst.index] = true;
  }
  for (std::size_t array = 0; array < m_arrays.size(); ++array) {
    const auto &rows = program.arrays[array].rows;
    for (std::size_t row = 0; m_arrays[array] && row < rows.size(); ++row)
      if (m_elements[rows[row]].empty())
        m_elements[rows[row]] = numbered("c", array) + "[" + std::to_string(row) + "]";
  }
}

void Names::use(const ir::Operand &operand) {
  if (operand.relative) {
    m_arrays[operand.index] = true;
    m_addresses[operand.address] = true;
  } else if (operand.file == File::Temporary) {
    m_temporaries[operand.index] = true;
  } else if (operand.file == File::Parameter) {
    m_parameters[operand.index] = true;
  }
}

std::string Names::declarations(int scratch) const {
  return temporaries(scratch) + list("ADDRESS", "a", m_addresses) + parameters();
}

int Names::temporaryCount() const {
  return int(std::count(m_temporaries.begin(), m_temporaries.end(), true));
}

std::string Names::temporaries(int scratch) const {
  std::string text = list("TEMP", "t", m_temporaries);
  const std::string more = list("TEMP", "s", std::vector<bool>(std::size_t(scratch), true));
  if (text.empty() || more.empty())
    return text + more;
  return text.replace(text.size() - 2, 2, ", " + more.substr(5));
}

std::string Names::parameters() const {
  std::string text;
  for (std::size_t i = 0; i < m_parameters.size(); ++i)
    if (m_parameters[i] && m_elements[i].empty())
      text += "PARAM " + numbered("p", i) + " = " + bindingOf(m_program.parameters[i]) + ";\n";
  for (std::size_t i = 0; i < m_arrays.size(); ++i) {
    if (!m_arrays[i])
      continue;
    const std::vector<std::uint16_t> &rows = m_program.arrays[i].rows;
    text += "PARAM " + numbered("c", i) + "[" + std::to_string(rows.size()) + "] = { " +
            bindingsOf(m_program, rows) + " };\n";
  }
  return text;
}

std::string Names::source(const ir::Operand &operand) const {
  if (operand.relative) {
    std::string offset;
    if (operand.offset != 0)
      offset = (operand.offset > 0 ? "+" : "") + std::to_string(operand.offset);
    return numbered("c", operand.index) + "[" + numbered("a", operand.address) + ".x" + offset +
           "]";
  }
  switch (operand.file) {
  case File::Temporary:
    return numbered("t", operand.index);
  case File::Attribute:
    return ir::bindingText(m_program.attributes[operand.index], m_program.language);
  case File::Parameter:
    return m_elements[operand.index].empty() ? numbered("p", operand.index)
                                             : m_elements[operand.index];
  case File::Output:
  case File::Address:
    break; // never read
  }
  return "";
}

std::string Names::destination(const ir::Destination &dst) const {
  if (dst.file == File::Temporary)
    return numbered("t", dst.index);
  if (dst.file == File::Address)
    return numbered("a", dst.index);
  const ir::Output &output = m_program.outputs[dst.index];
  // The grammar allows an index only under this option.
  if (output.kind == ir::OutputKind::Color && !m_program.options.drawBuffers)
    return "result.color";
  return ir::bindingText(output);
}

} // namespace arbiter::fp::assembly
