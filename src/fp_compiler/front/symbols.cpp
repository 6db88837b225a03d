#include "fp_compiler/front/symbols.h"

#include "util/suggest.h"

namespace arbiter::fp {

namespace {
constexpr std::size_t kSuggested = 64;
}

const Symbol *SymbolTable::declare(std::string_view name, const Symbol &symbol) {
  const Symbol *const before = Declarations::declare(name, symbol);
  if (!before && symbol.kind != SymbolKind::Unknown && m_latest.size() < kSuggested)
    m_latest.push_back(name);
  return before;
}

std::string SymbolTable::suggest(std::string_view name) const {
  return didYouMean(name, m_latest, "declare it first, with TEMP, PARAM, ATTRIB, OUTPUT or ALIAS");
}

} // namespace arbiter::fp
