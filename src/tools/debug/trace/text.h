#pragma once
#include <string>

#include "tools/debug/trace/trace.h"

namespace arbiter::tools::debug {

/// What a reader wants to be shown of a trace.
struct TextOptions {
  std::size_t from = 0;
  std::size_t to = ~std::size_t(0);  ///< the last row
  std::optional<std::size_t> marked; ///< a row with an arrow: where a run stopped
};

/// The inputs: a line each.
[[nodiscard]] std::string inputsText(const Trace &trace);
/// The rows: each instruction with what it read, fetched and wrote.
[[nodiscard]] std::string rowsText(const Trace &trace, const TextOptions &options);
/// The results: a line each, with the colour in 8 bits.
[[nodiscard]] std::string resultsText(const Trace &trace);

} // namespace arbiter::tools::debug
