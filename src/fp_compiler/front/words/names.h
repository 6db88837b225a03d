#pragma once
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "fp_compiler/front/symbols.h"

namespace arbiter::fp {

/// What the text does with a name where it stands.
enum class Access : std::uint8_t { Declare, Read, Write };

/// One place where a name stands.
struct NameUse {
  Span span;
  std::uint32_t name = 0; ///< into NameTable::names()
  Access access = Access::Read;
};

/// A name of the text: a variable's, or of ATI's text a register's or a constant's.
struct Name {
  std::string_view text;
  SymbolKind kind = SymbolKind::Unknown; ///< of its first declaration
  Span declared;                         ///< where it is declared first; empty if nowhere
};

/// Every place where a program's text has a name: for editors, which ask the parser to keep one.
/// The table views the text, which must outlive it.
class NameTable {
public:
  /// Notes a use of a name; `kind` counts where it is declared.
  void add(std::string_view text, Span span, Access access, SymbolKind kind = SymbolKind::Unknown);

  [[nodiscard]] const std::vector<Name> &names() const { return m_names; }
  /// In text order.
  [[nodiscard]] const std::vector<NameUse> &uses() const { return m_uses; }
  /// The name of that text; nullptr if there is none.
  [[nodiscard]] const Name *find(std::string_view text) const;
  /// The use that byte \p offset is in, or directly after; nullptr if there is none. Requires
  /// sort().
  [[nodiscard]] const NameUse *at(std::uint32_t offset) const;
  /// Puts uses() in text order: a declaration is noted when its statement ends.
  void sort();
  /// Every place becomes one of a longer text, which has this one from byte \p by on.
  void move(std::uint32_t by);

private:
  std::vector<Name> m_names;
  std::vector<NameUse> m_uses;
  std::unordered_map<std::string_view, std::uint32_t> m_index;
};

} // namespace arbiter::fp
