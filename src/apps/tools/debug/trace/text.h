#pragma once
#include <string>

#include "apps/tools/debug/trace/trace.h"

namespace arbiter::tools::debug {

/// Selects the rows of a trace to print.
struct TextOptions {
  std::size_t from = 0;
  std::size_t to = ~std::size_t(0);  ///< the last row
  std::optional<std::size_t> marked; ///< the row at which a run stopped, marked by an arrow
};

/// Lists the inputs, one per line.
[[nodiscard]] std::string inputsText(const Trace &trace);
/// Lists the rows: each instruction with the values that it read, fetched and wrote.
[[nodiscard]] std::string rowsText(const Trace &trace, const TextOptions &options);
/// Lists the results, one per line, with the color in 8 bits.
[[nodiscard]] std::string resultsText(const Trace &trace);

} // namespace arbiter::tools::debug
