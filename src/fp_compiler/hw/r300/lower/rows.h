#pragma once
#include <algorithm>

#include "fp_compiler/hw/r300/lower/flow.h"

/// Constant memory while it is being collected: equal rows are one, and numbers are found in any
/// row that has them where an argument can take them.
namespace arbiter::fp::hw::r300 {

class Rows {
public:
  Rows(const ir::Program &program, std::vector<Row> &rows) : m_program(program), m_rows(rows) {
    m_ofParameter.assign(program.parameters.size(), kNone);
  }

  /// The row of a program's parameter whose value is not known.
  std::uint16_t parameter(std::uint16_t index, std::uint16_t origin);
  /// One of the driver's own whose value is not known.
  std::uint16_t own(Constant::Kind kind, std::uint16_t index, std::uint16_t origin);

  struct Place {
    std::uint16_t row = 0;
    std::uint8_t select = 0;
    bool negate = false;
  };
  /// Literals that an RGB argument takes for \p components; adds what is not there yet.
  Place rgb(const Refs &literals, std::uint8_t components, std::uint16_t origin);
  /// Likewise for an alpha argument; the select is an AlphaSelect.
  Place alpha(const Ref &literal, std::uint16_t origin);

  /// Literals where \p select, an RgbSelect of colours or Www, takes them for \p components.
  Place at(const Refs &literals, std::uint8_t components, std::uint8_t select,
           std::uint16_t origin);

private:
  /// Beyond these nothing is looked for: a program with so many is far from fitting.
  [[nodiscard]] std::size_t searched() const { return std::min<std::size_t>(m_rows.size(), 256); }
  bool find(const Row &row, const Refs &literals, std::uint8_t components, Place &place) const;
  bool place(Row &row, const Refs &literals, std::uint8_t components, Place &place) const;
  std::uint16_t add(const Constant &constant, std::uint8_t filled, bool known);
  std::uint16_t known(std::uint16_t parameter, std::uint16_t origin);

  const ir::Program &m_program;
  std::vector<Row> &m_rows;
  std::vector<std::uint16_t> m_ofParameter;
};

} // namespace arbiter::fp::hw::r300
