#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/diagnostic.h"
#include "tools/advise/advise.h"
#include "util/json.h"

/// Advice as text and as JSON.
namespace arbiter::tools::advise {

/// Lines that edits change: what stands there, and what will.
struct Change {
  std::uint32_t line = 1; ///< the first, from 1
  std::vector<std::string> old, now;
};
[[nodiscard]] std::vector<Change> changesOf(std::string_view text, const Edits &edits);

/// The advice as a compiler's note, which is rendered as diagnostics are.
[[nodiscard]] fp::Diagnostic noteOf(const Advice &advice);
/// "file:line:column: note: message [rule]: ALU 4 -> 1"
/// \param note the first line of the rendered note
[[nodiscard]] std::string lineText(const std::string &note, const Advice &advice);
/// The note, its cost, then the changed lines with - and +; of advice what the application would
/// do, and what must hold. \param note rendered: its line, the source line and a caret
[[nodiscard]] std::string fullText(const std::string &note, std::string_view text,
                                   const Advice &advice);

/// The value of "advice": an array, described in arbiter(1).
void writeAdvice(JsonWriter &json, std::string_view text, const std::vector<Advice> &advice);
/// The value of "fixed".
void writeFixed(JsonWriter &json, const Fixed &fixed);

} // namespace arbiter::tools::advise
