#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "fp_compiler/span.h"
#include "tools/lsp/json.h"

namespace arbiter::tools::lsp {

/// What a position's "character" counts. UTF-16 is the protocol's own; a client may offer UTF-8.
enum class Encoding : std::uint8_t { Utf16, Utf8 };

/// A text's bytes against the protocol's lines and characters, both from 0. CR LF, LF and CR each
/// end a line. Bytes that are no UTF-8 count one character each.
class TextMap {
public:
  TextMap() = default;
  /// Views the text.
  TextMap(std::string_view text, Encoding encoding);

  /// The byte of a position. Beyond a line's end it is the line's end, beyond the last line the
  /// text's; within a character it is the character's first byte. Nothing for a position that is
  /// none.
  [[nodiscard]] std::optional<std::uint32_t> offset(const Json &position) const;
  [[nodiscard]] Json position(std::uint32_t offset) const;
  [[nodiscard]] Json range(fp::Span span) const;

  [[nodiscard]] std::uint32_t lineOf(std::uint32_t offset) const;
  /// Without what ends it.
  [[nodiscard]] fp::Span line(std::uint32_t number) const;
  [[nodiscard]] std::uint32_t lines() const { return std::uint32_t(m_begins.size()); }

private:
  std::string_view m_text;
  Encoding m_encoding = Encoding::Utf16;
  std::vector<std::uint32_t> m_begins = {0};
};

} // namespace arbiter::tools::lsp
