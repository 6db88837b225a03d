#pragma once
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "fp_compiler/front/symbols.h"

namespace arbiter::fp {

/// How the text uses a name at one place.
enum class Access : std::uint8_t { Declare, Read, Write };

/// A place where a name is used.
struct NameUse {
  Span span;
  std::uint32_t name = 0; ///< into NameTable::names()
  Access access = Access::Read;
};

/// A name of the text: that of a variable, or in ATI's text of a register or a constant.
struct Name {
  std::string_view text;
  SymbolKind kind = SymbolKind::Unknown; ///< of its first declaration
  Span declared;                         ///< where it is declared first; empty if nowhere
};

/// Every place where a program's text has a name. The parser fills it for editors. The table refers
/// to the text, which must outlive it.
class NameTable {
public:
  /// Adds a use of a name. `kind` is used only for a declaration.
  void add(std::string_view text, Span span, Access access, SymbolKind kind = SymbolKind::Unknown);

  [[nodiscard]] const std::vector<Name> &names() const { return m_names; }
  /// Returns the uses in text order, after sort().
  [[nodiscard]] const std::vector<NameUse> &uses() const { return m_uses; }
  /// Returns the name of that text; nullptr if there is none.
  [[nodiscard]] const Name *find(std::string_view text) const;
  /// Returns the use that contains byte \p offset, or ends there; nullptr if there is none.
  /// Requires: sort().
  [[nodiscard]] const NameUse *at(std::uint32_t offset) const;
  /// Sorts uses() by their place. A declaration is added at the end of its statement.
  void sort();
  /// Moves every place by \p by bytes, for a longer text that has this one from there on.
  void move(std::uint32_t by);

private:
  std::vector<Name> m_names;
  std::vector<NameUse> m_uses;
  std::unordered_map<std::string_view, std::uint32_t> m_index;
};

} // namespace arbiter::fp
