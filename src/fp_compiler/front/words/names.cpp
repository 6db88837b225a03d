#include "fp_compiler/front/words/names.h"

#include <algorithm>

namespace arbiter::fp {

void NameTable::add(std::string_view text, Span span, Access access, SymbolKind kind) {
  const auto [entry, isNew] = m_index.try_emplace(text, std::uint32_t(m_names.size()));
  if (isNew)
    m_names.push_back({text});
  Name &name = m_names[entry->second];
  if (access == Access::Declare && name.declared.end == 0) {
    name.kind = kind;
    name.declared = span;
  }
  m_uses.push_back({span, entry->second, access});
}

const Name *NameTable::find(std::string_view text) const {
  const auto entry = m_index.find(text);
  return entry == m_index.end() ? nullptr : &m_names[entry->second];
}

const NameUse *NameTable::at(std::uint32_t offset) const {
  // Names do not touch, so only the last one that begins before the offset can reach it.
  const auto after =
      std::upper_bound(m_uses.begin(), m_uses.end(), offset,
                       [](std::uint32_t at, const NameUse &use) { return at < use.span.begin; });
  if (after == m_uses.begin())
    return nullptr;
  const NameUse &use = *(after - 1);
  return offset <= use.span.end ? &use : nullptr;
}

void NameTable::sort() {
  std::sort(m_uses.begin(), m_uses.end(),
            [](const NameUse &a, const NameUse &b) { return a.span.begin < b.span.begin; });
}

void NameTable::move(std::uint32_t by) {
  for (NameUse &use : m_uses)
    use.span = {use.span.begin + by, use.span.end + by};
  for (Name &name : m_names)
    if (name.declared.end != 0)
      name.declared = {name.declared.begin + by, name.declared.end + by};
}

} // namespace arbiter::fp
