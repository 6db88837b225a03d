#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "tools/advise/advise.h"
#include "util/json.h"

/// Prints suggestions as text and as JSON.
namespace arbiter::tools::advise {

/// A group of changed lines, before and after.
struct Change {
  std::uint32_t line = 1; ///< number of the first line, from 1
  std::vector<std::string> old, now;
};
[[nodiscard]] std::vector<Change> changesOf(std::string_view text, const Edits &edits);

/// Returns "file:line:column: note: message [rule]: ALU 4 -> 1".
[[nodiscard]] std::string lineText(std::string_view file, std::string_view text,
                                   const Advice &advice);
/// Returns lineText(), the source line with a caret, and the changed lines with - and +. For
/// advice, adds the application's part and the condition.
[[nodiscard]] std::string fullText(std::string_view file, std::string_view text,
                                   const Advice &advice);

/// Writes the value of "advice": an array, described in arbiter(1).
void writeAdvice(JsonWriter &json, std::string_view text, const std::vector<Advice> &advice);
/// Writes the value of "fixed".
void writeFixed(JsonWriter &json, const Fixed &fixed);

} // namespace arbiter::tools::advise
