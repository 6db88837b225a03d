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

/// The names of a program (3.11.3). Keys point into the program text, which must outlive the table.
class SymbolTable {
public:
  /// Declares a name and returns nullptr. If the name is already declared, returns its symbol
  /// instead.
  const Symbol *declare(std::string_view name, const Symbol &symbol);
  /// Returns the symbol of a name; nullptr if it is not declared.
  [[nodiscard]] const Symbol *find(std::string_view name) const;
  /// Returns a hint for an undeclared name: the most similar declared name, or how to declare it.
  [[nodiscard]] std::string suggest(std::string_view name) const;

private:
  std::unordered_map<std::string_view, Symbol> m_symbols;
  std::vector<std::string_view> m_latest; ///< the names to suggest, bounded
};

} // namespace arbiter::fp
