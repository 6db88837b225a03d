#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "apps/tools/advise/advise.h"
#include "fp_compiler/diagnostic.h"
#include "util/json.h"

/// Prints suggestions as text and as JSON.
namespace arbiter::tools::advise {

/// A group of changed lines, before and after.
struct Change {
  std::uint32_t line = 1; ///< number of the first line, from 1
  std::vector<std::string> old, now;
};
[[nodiscard]] std::vector<Change> changesOf(std::string_view text, const Edits &edits);

/// Returns a suggestion as a compiler's note, which is rendered like other diagnostics.
[[nodiscard]] fp::Diagnostic noteOf(const Advice &advice);
/// Returns "file:line:column: note: message [rule]: ALU 4 -> 1".
/// \param note the first line of the rendered note
[[nodiscard]] std::string lineText(const std::string &note, const Advice &advice);
/// Returns the note with its cost, and the changed lines with - and +. For advice, adds the
/// application's part and the condition.
/// \param note the rendered note: its line, the source line and a caret
[[nodiscard]] std::string fullText(const std::string &note, std::string_view text,
                                   const Advice &advice);

/// Writes the value of "advice": an array, described in arbiter(1).
void writeAdvice(JsonWriter &json, std::string_view text, const std::vector<Advice> &advice);
/// Writes the value of "fixed".
void writeFixed(JsonWriter &json, const Fixed &fixed);

} // namespace arbiter::tools::advise
