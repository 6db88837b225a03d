#include "fp_compiler/vertex_shader/symbols.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace arbiter::fp::vertex_shader {

namespace {

/// Returns the nearest number that program text can express.
float finite(float value) {
  constexpr float kMax = std::numeric_limits<float>::max();
  return std::isnan(value) ? 0.0f : std::clamp(value, -kMax, kMax);
}

} // namespace

Source Symbols::literal(float value) {
  const auto found = std::find_if(m_literals.begin(), m_literals.end(),
                                  [&](const auto &entry) { return entry.first == value; });
  if (found != m_literals.end())
    return found->second;
  return m_literals.emplace_back(value, m_builder.constant(value)).second;
}

Source Symbols::read(std::uint32_t symbol, int row) {
  const Symbol &known = m_shader.symbols[symbol];
  const Source source = whole(symbol, row);
  if (known.type != DataType::Scalar)
    return source;
  return source.swz(kLetters[known.from == From::State ? known.component : 0]);
}

Target Symbols::local(std::uint32_t symbol, int row) {
  std::optional<Target> &known = m_rows[symbol].registers[std::size_t(row)];
  if (!known)
    known = m_builder.temporary("s" + std::to_string(symbol) +
                                (row == 0 ? "" : "_" + std::to_string(row)));
  return *known;
}

Source Symbols::parameter(std::uint32_t symbol, int row) {
  std::optional<Source> &known = m_rows[symbol].sources[std::size_t(row)];
  if (known)
    return *known;
  const Symbol &of = m_shader.symbols[symbol];
  if (of.from == From::Constant) {
    const ir::Vec4 &v = of.constant[std::size_t(row)];
    known = m_builder.constant(finite(v[0]), finite(v[1]), finite(v[2]), finite(v[3]));
  } else if (of.from == From::Invariant) {
    known = m_builder.env(int(m_env.size()));
    m_env.push_back({symbol, std::uint8_t(row)});
  } else {
    ir::StateRef state = of.state;
    state.row = std::uint8_t(state.row + row);
    known = m_builder.state(state);
  }
  return *known;
}

Source Symbols::whole(std::uint32_t symbol, int row) {
  const Symbol &of = m_shader.symbols[symbol];
  if (of.from == From::Local)
    return local(symbol, row).read();
  if (of.from == From::State && of.isDirection)
    return direction(symbol);
  if (isParameter(of))
    return parameter(symbol, row);
  Rows &rows = m_rows[symbol];
  if (!rows.sources[0]) {
    if (of.type == DataType::Matrix)
      transpose(of, rows);
    else
      rows.sources[0] = attribute(of, 0);
  }
  return *rows.sources[std::size_t(row)];
}

Source Symbols::direction(std::uint32_t symbol) {
  std::optional<Target> &known = m_rows[symbol].registers[0];
  if (!known) {
    known = m_builder.temporary("direction");
    m_builder.op(Opcode::Swz, *known, {parameter(symbol, 0).swz("xyz0")});
  }
  return known->read();
}

Source Symbols::attribute(const Symbol &symbol, int column) {
  const ir::Attribute &of = symbol.attributes[std::size_t(column)];
  const Source source = m_builder.attribute(of.kind, of.index);
  if (symbol.isDirection) {
    const Target to = m_builder.temporary("normal");
    m_builder.op(Opcode::Swz, to, {source.swz("xyz0")});
    return to.read();
  }
  if (!symbol.clampsAttributes)
    return source;
  const Target to = m_builder.temporary();
  m_builder.op(Opcode::Max, to, {source, literal(-1.0f)});
  m_builder.op(Opcode::Min, to, {to.read(), literal(1.0f)});
  return to.read();
}

void Symbols::transpose(const Symbol &symbol, Rows &rows) {
  std::array<Source, 4> columns;
  for (int column = 0; column < 4; ++column)
    columns[std::size_t(column)] = attribute(symbol, column);
  for (std::size_t row = 0; row < 4; ++row) {
    const Target to = m_builder.temporary();
    for (std::size_t column = 0; column < 4; ++column)
      m_builder.op(Opcode::Mov, to.mask(kLetters[column]), {columns[column].swz(kLetters[row])});
    rows.sources[row] = to.read();
  }
}

} // namespace arbiter::fp::vertex_shader
