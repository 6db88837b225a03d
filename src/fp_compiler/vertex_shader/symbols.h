#pragma once
#include <array>
#include <optional>
#include <vector>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/vertex_shader/lower.h"

namespace arbiter::fp::vertex_shader {

/// The symbols of a shader as registers of the program that is built: each gets what it needs when
/// it is first named.
class Symbols {
public:
  Symbols(ir::Builder &builder, const Shader &shader)
      : m_builder(builder), m_shader(shader), m_rows(shader.symbols.size()) {}

  [[nodiscard]] const Symbol &operator[](std::uint32_t symbol) const {
    return m_shader.symbols[symbol];
  }
  /// A row of the symbol's value; of a scalar its one component, four times.
  [[nodiscard]] ir::Source read(std::uint32_t symbol, int row = 0);
  /// The register of a row of a local.
  [[nodiscard]] ir::Target local(std::uint32_t symbol, int row = 0);
  /// A row as a parameter, of which arrays can be made: of constants, invariants and state alone.
  [[nodiscard]] ir::Source parameter(std::uint32_t symbol, int row);
  [[nodiscard]] static bool isParameter(const Symbol &symbol) {
    return symbol.from != From::Local && symbol.from != From::Attribute;
  }
  [[nodiscard]] ir::Source literal(float value);
  [[nodiscard]] std::vector<EnvRow> takeEnv() { return std::move(m_env); }

private:
  struct Rows {
    std::array<std::optional<ir::Source>, 4> sources;
    std::array<std::optional<ir::Target>, 4> registers; ///< of a local, or a direction
  };
  [[nodiscard]] ir::Source whole(std::uint32_t symbol, int row);
  /// Of a row of state without its fourth component.
  [[nodiscard]] ir::Source direction(std::uint32_t symbol);
  [[nodiscard]] ir::Source attribute(const Symbol &symbol, int column);
  /// Rows of a matrix that is given as columns.
  void transpose(const Symbol &symbol, Rows &rows);

  ir::Builder &m_builder;
  const Shader &m_shader;
  std::vector<Rows> m_rows;
  std::vector<EnvRow> m_env;
  std::vector<std::pair<float, ir::Source>> m_literals;
};

} // namespace arbiter::fp::vertex_shader
