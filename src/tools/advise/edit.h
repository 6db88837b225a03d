#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/span.h"

/// Changes of a text, as editors take them.
namespace arbiter::tools::advise {

/// The bytes of `span` become `text`. An empty span inserts.
struct Edit {
  fp::Span span;
  std::string text;
  bool operator==(const Edit &) const = default;
};
using Edits = std::vector<Edit>;

/// By their places; those of one place keep their order.
void sort(Edits &edits);

/// The text with all of the edits made. Nothing if two of them overlap or one leaves the text.
/// Requires: sort() came before.
[[nodiscard]] std::optional<std::string> applied(std::string_view text, const Edits &edits);

/// The byte of the old text that byte \p offset of the new one was; nothing for one that an edit
/// wrote. Requires: sort() came before.
[[nodiscard]] std::optional<std::uint32_t> before(const Edits &edits, std::uint32_t offset);

/// What has to go so that a statement goes: it and its semicolon, and the line if nothing else is
/// on it.
[[nodiscard]] fp::Span wholeStatement(std::string_view text, fp::Span statement);

/// An edit that puts statements before the one that begins at \p begin: on lines of their own, as
/// far to the right, if it begins its line.
[[nodiscard]] Edit insertedBefore(std::string_view text, std::uint32_t begin,
                                  const std::vector<std::string> &statements);

} // namespace arbiter::tools::advise
