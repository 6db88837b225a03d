#pragma once
#include <nlohmann/json.hpp>

#include "tools/debug/pixel/verdict.h"
#include "tools/debug/trace/compare.h"

/// Traces as JSON, for scripts and editors. A number that is none is a string: "nan", "inf",
/// "-inf".
namespace arbiter::tools::debug {

using Json = nlohmann::json;

/// Of the members that a trace is printed with; it changes when one changes its meaning or goes.
inline constexpr int kTraceSchema = 1;

/// {numerics, attributes, parameters, rows, results, discarded}. Byte offsets are those of the
/// text; lines and columns count from 1. `second` members are there where the value differs.
[[nodiscard]] Json traceJson(const Trace &trace);
[[nodiscard]] Json verdictJson(const Verdict &verdict, const Trace &trace);
/// \param a the trace that `row` counts in, \p b the one of `other_row`
[[nodiscard]] Json differenceJson(const Difference &difference, const Trace &a, const Trace &b);
[[nodiscard]] Json vectorJson(const Vec4 &value);

} // namespace arbiter::tools::debug
