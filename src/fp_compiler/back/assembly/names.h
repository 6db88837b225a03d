#pragma once
#include <string>
#include <vector>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::assembly {

/// The shortest decimal that rounds back to \p value. Requires: it is finite.
[[nodiscard]] std::string numeral(float value);

/// The names of a program's registers in the text, and the declarations they need.
class Names {
public:
  explicit Names(const ir::Program &program);

  /// TEMP, ADDRESS and PARAM statements for what the code uses.
  /// \param scratch temporaries to declare besides, "s0" and on
  [[nodiscard]] std::string declarations(int scratch) const;
  /// How many temporaries the code uses, beside those.
  [[nodiscard]] int temporaryCount() const;
  /// "t3", "vertex.normal", "p2", "c0[1]", "c0[a0.x+3]"
  [[nodiscard]] std::string source(const ir::Operand &operand) const;
  /// "t3", "result.color", "a0"
  [[nodiscard]] std::string destination(const ir::Destination &dst) const;

private:
  [[nodiscard]] std::string temporaries(int scratch) const;
  [[nodiscard]] std::string parameters() const;
  void use(const ir::Operand &operand);

  const ir::Program &m_program;
  std::vector<bool> m_temporaries, m_parameters, m_addresses, m_arrays;
  /// Where a row of a used array is read by number: "c0[1]"; empty for other rows.
  std::vector<std::string> m_elements;
};

} // namespace arbiter::fp::assembly
