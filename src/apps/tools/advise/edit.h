#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/span.h"

/// Represents changes of a text as editors do.
namespace arbiter::tools::advise {

/// Replaces the bytes of `span` by `text`. An empty span inserts.
struct Edit {
  fp::Span span;
  std::string text;
  bool operator==(const Edit &) const = default;
};
using Edits = std::vector<Edit>;

/// Sorts edits by position; edits at one position keep their order.
void sort(Edits &edits);

/// Returns the text after all edits. Returns nothing if two edits overlap or one lies outside the
/// text.
/// Requires: edits are sorted by sort().
[[nodiscard]] std::optional<std::string> applied(std::string_view text, const Edits &edits);

/// Returns the old position of byte \p offset in the new text, or nothing if an edit wrote it.
/// Requires: edits are sorted by sort().
[[nodiscard]] std::optional<std::uint32_t> before(const Edits &edits, std::uint32_t offset);

/// Returns the span to delete for removing a statement: it and its semicolon, or the whole line if
/// nothing else is on it.
[[nodiscard]] fp::Span wholeStatement(std::string_view text, fp::Span statement);

/// Returns an edit that inserts statements before the one at \p begin. If that begins its line, the
/// new statements get their own lines with the same indentation.
[[nodiscard]] Edit insertedBefore(std::string_view text, std::uint32_t begin,
                                  const std::vector<std::string> &statements);

} // namespace arbiter::tools::advise
