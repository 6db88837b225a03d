#pragma once
#include <algorithm>
#include <bit>

#include "fp_compiler/hw/r300/lower/flow.h"

/// Collects constant memory. Equal rows are merged, and a number is found in any row where an
/// argument can read it.
namespace arbiter::fp::hw::r300 {

/// True if both have the same bits.
[[nodiscard]] inline bool sameNumber(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

class Rows {
public:
  Rows(const ir::Program &program, std::vector<Row> &rows) : m_program(program), m_rows(rows) {
    m_ofParameter.assign(program.parameters.size(), kNone);
  }

  /// Returns the row of a program's parameter whose value is not known.
  std::uint16_t parameter(std::uint16_t index, std::uint16_t origin);
  /// Returns the row of a driver's constant whose value is not known.
  std::uint16_t own(Constant::Kind kind, std::uint16_t index, std::uint16_t origin);

  struct Place {
    std::uint16_t row = 0;
    std::uint8_t select = 0;
    bool negate = false;
  };
  /// Returns where an RGB argument reads the literals for \p components, and adds missing numbers.
  Place rgb(const Refs &literals, std::uint8_t components, std::uint16_t origin);
  /// Returns where an alpha argument reads the literal. The select is an AlphaSelect.
  Place alpha(const Ref &literal, std::uint16_t origin);

  /// Returns where the literals are readable through \p select for \p components.
  /// \param select an RgbSelect of colours, or Www
  Place at(const Refs &literals, std::uint8_t components, std::uint8_t select,
           std::uint16_t origin);

private:
  /// Limits how many rows are searched. A program with more rows is far from fitting.
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
