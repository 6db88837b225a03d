#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "fp_compiler/span.h"

namespace arbiter::fp {

enum class SymbolKind : std::uint8_t {
  Unknown, ///< used though undeclared, or declared in error: reported once, then accepted
  Temporary,
  Attribute,
  Parameter,
  ParameterArray,
  Output,
  Address, ///< vertex programs: row of Program::addresses
};

/// The sizes SHORT and LONG of NV_fragment_program_option. The default is LONG.
enum class RegisterSize : std::uint8_t { Long, Short };

/// The meaning of a name. An ALIAS has a copy of its variable's symbol.
struct Symbol {
  SymbolKind kind = SymbolKind::Unknown;
  std::uint16_t index = 0;                ///< row of the register file; of an array, its number
  Span declared;                          ///< the name where it was declared
  RegisterSize size = RegisterSize::Long; ///< of a temporary or a result
};

/// The names that a program declares, with what they mean. Keys point into the program text, which
/// must outlive the table. A meaning whose kind is Unknown gives way to the next one.
template <typename Meaning> class Declarations {
public:
  /// Declares a name and returns nullptr. If the name is already declared, returns its meaning
  /// instead.
  const Meaning *declare(std::string_view name, const Meaning &meaning) {
    const auto [entry, isNew] = m_meanings.try_emplace(name, meaning);
    if (!isNew && entry->second.kind != decltype(meaning.kind)::Unknown)
      return &entry->second;
    entry->second = meaning;
    return nullptr;
  }
  /// Returns the meaning of a name; nullptr if it is not declared.
  [[nodiscard]] const Meaning *find(std::string_view name) const {
    const auto entry = m_meanings.find(name);
    return entry == m_meanings.end() ? nullptr : &entry->second;
  }

private:
  std::unordered_map<std::string_view, Meaning> m_meanings;
};

/// The names of an ARB program (3.11.3).
class SymbolTable : public Declarations<Symbol> {
public:
  const Symbol *declare(std::string_view name, const Symbol &symbol);
  /// Returns a hint for an undeclared name: the most similar declared name, or how to declare it.
  [[nodiscard]] std::string suggest(std::string_view name) const;

private:
  std::vector<std::string_view> m_latest; ///< the names to suggest, bounded
};

} // namespace arbiter::fp
