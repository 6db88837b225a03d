#pragma once
#include <nlohmann/json.hpp>

#include "apps/tools/debug/pixel/verdict.h"
#include "apps/tools/debug/trace/compare.h"

/// Writes traces as JSON for scripts and editors. Values that are not finite are strings: "nan",
/// "inf", "-inf".
namespace arbiter::tools::debug {

using Json = nlohmann::json;

/// Returns {numerics, attributes, parameters, rows, results, discarded}. Offsets are bytes of the
/// text; lines and columns count from 1. A `second` member exists if the second arithmetic's value
/// differs.
[[nodiscard]] Json traceJson(const Trace &trace);
[[nodiscard]] Json verdictJson(const Verdict &verdict, const Trace &trace);
/// Returns a difference.
/// \param a the trace of `row`
/// \param b the trace of `other_row`
[[nodiscard]] Json differenceJson(const Difference &difference, const Trace &a, const Trace &b);
[[nodiscard]] Json vectorJson(const Vec4 &value);

} // namespace arbiter::tools::debug
