#pragma once
#include <optional>
#include <string>

#include "apps/tools/debug/json.h"
#include "apps/tools/debug/pixel/watch.h"

/// Formats the results of one debugger run as text and as JSON. Uses neither GL nor files.
namespace arbiter::tools::debug {

/// Another program that the document's is compared with, and their first difference.
struct Beside {
  std::string name;
  Trace trace;
  std::optional<Difference> first;
  std::optional<std::string> result; ///< the first result that differs
};

/// The values that --watch drew.
struct Watched {
  std::string value;        ///< REG@LINE
  std::string picture;      ///< the file; empty: none
  std::optional<Vec4> here; ///< in the pixel; empty: the mesh does not cover it
  Extent extent;
};

struct Findings {
  std::string document;
  int x = 0, y = 0; ///< pixel, from the lower left
  int width = 0, height = 0;
  int pass = 1, frame = 0;
  Trace trace;
  std::string breakOn;                ///< the condition to stop at; empty: none
  std::optional<std::size_t> stopped; ///< the row at which the run stopped
  int line = 0;                       ///< the line to run to; 0: the end
  std::optional<Verdict> verdict;     ///< empty: without `beside` too, the trace's two arithmetics
                                      ///< are compared
  std::optional<Beside> beside;
  std::string note; ///< about who drew; may be empty
  std::optional<Watched> watch;
};

/// Returns kExitStopped if a run stopped, and kExitDiffers if a comparison found a difference.
[[nodiscard]] int exitCodeOf(const Findings &findings);
/// Returns the comparison's outcome in one line or a few: "swrast drew 8c5a3fff: equal".
[[nodiscard]] std::string summaryText(const Findings &findings);
[[nodiscard]] std::string findingsText(const Findings &findings);
/// Returns what was watched, in place of the trace.
[[nodiscard]] std::string watchedText(const Findings &findings);
/// Returns traceJson() with {schema, file, pixel, size, pass, frame, stopped, verdict, against,
/// watch, summary}.
[[nodiscard]] Json findingsJson(const Findings &findings);

} // namespace arbiter::tools::debug
