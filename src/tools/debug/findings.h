#pragma once
#include <optional>
#include <string>

#include "tools/debug/json.h"

/// What one run of the debugger found, for people and for programs. No GL, no files.
namespace arbiter::tools::debug {

/// Another program beside the document's, and where the two part.
struct Beside {
  std::string name;
  Trace trace;
  std::optional<Difference> first;
  std::optional<std::string> result; ///< the first result that differs
};

struct Findings {
  std::string document;
  int x = 0, y = 0; ///< the pixel, from the lower left
  int width = 0, height = 0;
  int pass = 1, frame = 0;
  Trace trace;
  std::string breakOn;                ///< empty: nothing was to be stopped at
  std::optional<std::size_t> stopped; ///< the row
  int line = 0;                       ///< that was run to; 0: the end
  std::optional<Verdict> verdict;     ///< without it and `beside`: the trace's own two arithmetics
  std::optional<Beside> beside;
  std::string note;    ///< of who drew; may be empty
  std::string watch;   ///< REG@LINE of --watch; empty: nothing was pictured
  std::string picture; ///< of it: the file
};

/// A comparison found a difference, or a run stopped.
[[nodiscard]] bool isDifferent(const Findings &findings);
/// The comparison's outcome in a line or a few: "swrast drew 8c5a3fff: equal".
[[nodiscard]] std::string summaryText(const Findings &findings);
[[nodiscard]] std::string findingsText(const Findings &findings);
/// traceJson() with {schema, file, pixel, size, pass, frame, stopped, verdict, against, watch,
/// summary}.
[[nodiscard]] Json findingsJson(const Findings &findings);

} // namespace arbiter::tools::debug
