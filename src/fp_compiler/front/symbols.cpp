#include "fp_compiler/front/symbols.h"

#include "util/suggest.h"

namespace arbiter::fp {

namespace {
constexpr std::size_t kSuggested = 64;
}

const Symbol *SymbolTable::declare(std::string_view name, const Symbol &symbol) {
  const auto [entry, isNew] = m_symbols.try_emplace(name, symbol);
  if (!isNew) {
    if (entry->second.kind != SymbolKind::Unknown)
      return &entry->second;
    entry->second = symbol;
  }
  if (symbol.kind != SymbolKind::Unknown && m_latest.size() < kSuggested)
    m_latest.push_back(name);
  return nullptr;
}

const Symbol *SymbolTable::find(std::string_view name) const {
  const auto entry = m_symbols.find(name);
  return entry == m_symbols.end() ? nullptr : &entry->second;
}

std::string SymbolTable::suggest(std::string_view name) const {
  return didYouMean(name, m_latest, "declare it first, with TEMP, PARAM, ATTRIB, OUTPUT or ALIAS");
}

} // namespace arbiter::fp
