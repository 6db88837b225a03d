#pragma once
#include <array>
#include <optional>
#include <vector>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/vertex_shader/lower.h"

namespace arbiter::fp::vertex_shader {

using ir::kLetters;
using ir::Opcode;
using ir::Source;
using ir::Target;

/// Maps the symbols of a shader to registers of the program under construction. Each register is
/// made on first use.
class Symbols {
public:
  Symbols(ir::Builder &builder, const Shader &shader)
      : m_builder(builder), m_shader(shader), m_rows(shader.symbols.size()) {}

  [[nodiscard]] const Symbol &operator[](std::uint32_t symbol) const {
    return m_shader.symbols[symbol];
  }
  /// Returns a row of the symbol's value, or a scalar's component four times.
  [[nodiscard]] Source read(std::uint32_t symbol, int row = 0);
  /// Returns the register of a row of a local.
  [[nodiscard]] Target local(std::uint32_t symbol, int row = 0);
  /// Returns a row as a parameter, as arrays need. Only constants, invariants and state have one.
  [[nodiscard]] Source parameter(std::uint32_t symbol, int row);
  [[nodiscard]] static bool isParameter(const Symbol &symbol) {
    return symbol.from != From::Local && symbol.from != From::Attribute;
  }
  [[nodiscard]] Source literal(float value);
  [[nodiscard]] std::vector<EnvRow> takeEnv() { return std::move(m_env); }

private:
  struct Rows {
    std::array<std::optional<Source>, 4> sources;
    std::array<std::optional<Target>, 4> registers; ///< of a local or a direction
  };
  [[nodiscard]] Source whole(std::uint32_t symbol, int row);
  /// Returns a row of state with its fourth component set to 0.
  [[nodiscard]] Source direction(std::uint32_t symbol);
  [[nodiscard]] Source attribute(const Symbol &symbol, int column);
  /// Converts a matrix from columns to rows.
  void transpose(const Symbol &symbol, Rows &rows);

  ir::Builder &m_builder;
  const Shader &m_shader;
  std::vector<Rows> m_rows;
  std::vector<EnvRow> m_env;
  std::vector<std::pair<float, Source>> m_literals;
};

} // namespace arbiter::fp::vertex_shader
