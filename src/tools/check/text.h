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
/// each resource, with its reasons where it is over.
[[nodiscard]] std::string fullText(const CheckedFile &file, const fp::hw::Profile &profile,
                                   const TextOptions &options);

/// "valid, within the native limits of r300"
[[nodiscard]] std::string verdict(const CheckedFile &file, const fp::hw::Profile &profile);

} // namespace arbiter::tools
