#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "tools/debug/trace/trace.h"
#include "util/result.h"

namespace arbiter::tools::debug {

struct DebugError {
  std::string message;
};

/// What a run stops at: a flag of a row, a KIL that discards, an error that 8 bits could show, or a
/// comparison with what a row has written to a component of a register.
struct Condition {
  enum class Kind { Flag, Kil, Differs, Compare } kind = Kind::Flag;
  enum class Relation { Less, Greater, LessEqual, GreaterEqual, Equal, Unequal };
  unsigned flag = 0;      ///< Flag
  std::string reg;        ///< Compare: as the program names it
  unsigned component = 0; ///< Compare
  Relation relation = Relation::Less;
  float bound = 0;
};

/// "nan", "inf", "over1", "below0", "unwritten", "kil", "differs", or "REG.c<NUMBER" with one of
/// < > <= >= = !=. Errors say which words there are.
[[nodiscard]] Result<Condition, DebugError> parseCondition(std::string_view text);

/// The name of a destination without its mask: "result.color" is a name, ".xy" is none.
[[nodiscard]] std::string_view registerName(std::string_view destination);

[[nodiscard]] bool holds(const Condition &condition, const Row &row);

/// The first row from \p from on at which it holds.
[[nodiscard]] std::optional<std::size_t> firstRow(const Trace &trace, const Condition &condition,
                                                  std::size_t from = 0);

/// Half a step of 8 bits: a smaller error cannot be seen.
inline constexpr float kVisible = 0.5f / 255.0f;

} // namespace arbiter::tools::debug
