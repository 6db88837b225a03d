#include "state/objects/symbol_table.h"

namespace arbiter::state {

using fp::vertex_shader::From;

GLuint VertexSymbolTable::add(const VertexSymbol &kind, GLuint count) {
  if (count > kFirstName + kMaxSymbols - m_next)
    return 0;
  const GLuint first = m_next;
  for (GLuint i = 0; i < count; ++i) {
    auto symbol = std::make_shared<VertexSymbol>(kind);
    symbol->first = first;
    symbol->count = count;
    // Variants get attributes of their own until none are left. Then attributes are reused, and a
    // shader that reads two variants with the same attribute exceeds the limits.
    if (symbol->isOwn(GL_VARIANT_EXT))
      for (int column = 0; column < symbol->rows(); ++column)
        symbol->meaning.attributes[std::size_t(column)] = {
            fp::ir::AttributeKind::Generic, kAttributes[m_nextAttribute++ % kAttributes.size()]};
    m_symbols.emplace(first + i, std::move(symbol));
  }
  m_next += count;
  return first;
}

GLuint VertexSymbolTable::generate(const VertexSymbol &kind, GLuint count) {
  const std::lock_guard lock(m_mutex);
  return add(kind, count);
}

GLuint VertexSymbolTable::bind(const VertexSymbol &kind, const std::array<GLenum, 3> &key) {
  const std::lock_guard lock(m_mutex);
  if (const auto known = m_bound.find(key); known != m_bound.end())
    return known->second;
  const GLuint name = add(kind, 1);
  if (name != 0)
    m_bound.emplace(key, name);
  return name;
}

std::shared_ptr<VertexSymbol> VertexSymbolTable::find(GLuint name) {
  const std::lock_guard lock(m_mutex);
  const auto found = m_symbols.find(name);
  return found == m_symbols.end() ? nullptr : found->second;
}

} // namespace arbiter::state
