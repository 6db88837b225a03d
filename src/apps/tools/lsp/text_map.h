#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "apps/tools/lsp/json.h"
#include "fp_compiler/span.h"

namespace arbiter::tools::lsp {

/// The unit of a position's "character". The protocol's default is UTF-16; a client may offer
/// UTF-8.
enum class Encoding : std::uint8_t { Utf16, Utf8 };

/// Converts between byte offsets and the protocol's lines and characters, which count from 0. CR
/// LF, LF and CR each end a line. A byte that is not UTF-8 counts as one character.
class TextMap {
public:
  TextMap() = default;
  /// Keeps a reference to the text.
  TextMap(std::string_view text, Encoding encoding);

  /// Returns the byte offset of a position. A position after a line's end means that end; one after
  /// the last line means the text's end. Within a character it is the character's first byte.
  /// Returns nothing if the JSON is no position.
  [[nodiscard]] std::optional<std::uint32_t> offset(const Json &position) const;
  [[nodiscard]] Json position(std::uint32_t offset) const;
  [[nodiscard]] Json range(fp::Span span) const;

  [[nodiscard]] std::uint32_t lineOf(std::uint32_t offset) const;
  /// Returns a line's span without its line end.
  [[nodiscard]] fp::Span line(std::uint32_t number) const;
  [[nodiscard]] std::uint32_t lines() const { return std::uint32_t(m_begins.size()); }

private:
  std::string_view m_text;
  Encoding m_encoding = Encoding::Utf16;
  std::vector<std::uint32_t> m_begins = {0};
};

} // namespace arbiter::tools::lsp
