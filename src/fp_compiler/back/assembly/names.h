#pragma once
#include <string>
#include <vector>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::assembly {

/// Returns the shortest decimal that rounds back to \p value. Requires: it is finite.
[[nodiscard]] std::string numeral(float value);

/// Names a program's registers in the text, and writes their declarations.
class Names {
public:
  explicit Names(const ir::Program &program);

  /// Returns the TEMP, ADDRESS and PARAM statements for what the code uses.
  /// \param scratch number of extra temporaries to declare, "s0" and on
  [[nodiscard]] std::string declarations(int scratch) const;
  /// Returns the number of temporaries that the code uses, without scratch ones.
  [[nodiscard]] int temporaryCount() const;
  /// Returns the text of a source register: "t3", "vertex.normal", "p2", "c0[1]", "c0[a0.x+3]".
  [[nodiscard]] std::string source(const ir::Operand &operand) const;
  /// Returns the text of a destination register: "t3", "result.color", "a0".
  [[nodiscard]] std::string destination(const ir::Destination &dst) const;

private:
  [[nodiscard]] std::string temporaries(int scratch) const;
  [[nodiscard]] std::string parameters() const;
  void use(const ir::Operand &operand);

  const ir::Program &m_program;
  std::vector<bool> m_temporaries, m_parameters, m_addresses, m_arrays;
  /// Names of rows of used arrays that are also read by number: "c0[1]"; empty for other rows.
  std::vector<std::string> m_elements;
};

} // namespace arbiter::fp::assembly
