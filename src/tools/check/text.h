#pragma once
#include <string>

#include "tools/check/checked_file.h"
#include "tools/check/terminal.h"

namespace arbiter::tools {

struct TextOptions {
  Style style;
  bool why = false; ///< every reason, node and cost, not those of what is over
};

/// The first lines of the diagnostics: "file:line:col: error: text [ID]".
[[nodiscard]] std::string briefText(const CheckedFile &file, const Style &style);

/// Diagnostics with source, caret and hint; the verdict; for a program that has counts a gauge for
/// each resource, with its reasons where it is over. Of a card without such programs that alone,
/// and what is wrong in the text under any card.
[[nodiscard]] std::string fullText(const CheckedFile &file, const fp::hw::Profile &profile,
                                   const TextOptions &options);

/// "x.fp: nv25: the card has no fragment programs", a line; empty of a card that has such programs.
[[nodiscard]] std::string lackText(const CheckedFile &file, const fp::hw::Profile &profile);

/// "valid, within the native limits of r300"
[[nodiscard]] std::string verdict(const CheckedFile &file, const fp::hw::Profile &profile);

} // namespace arbiter::tools
