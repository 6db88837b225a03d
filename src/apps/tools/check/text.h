#pragma once
#include <string>

#include "apps/tools/check/checked_file.h"
#include "apps/tools/check/terminal.h"

namespace arbiter::tools {

struct TextOptions {
  Style style;
  bool why = false; ///< show every reason, node and cost, not only those of resources over their
                    ///< limit
};

/// Returns the first lines of the diagnostics: "file:line:col: error: text [ID]".
[[nodiscard]] std::string briefText(const CheckedFile &file, const Style &style);

/// Returns diagnostics with source, caret and hint, and then the verdict. A program with counts has
/// a gauge for each resource, with reasons if it is over the limit. For a card without such
/// programs, says that alone, and what is wrong in the text for any card.
[[nodiscard]] std::string fullText(const CheckedFile &file, const fp::hw::Profile &profile,
                                   const TextOptions &options);

/// Returns the line "x.fp: nv25: the card has no fragment programs"; empty if the card has them.
[[nodiscard]] std::string lackText(const CheckedFile &file, const fp::hw::Profile &profile);

/// Returns a verdict such as "valid, within the native limits of r300".
[[nodiscard]] std::string verdict(const CheckedFile &file, const fp::hw::Profile &profile);

} // namespace arbiter::tools
