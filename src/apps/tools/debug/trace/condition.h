#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "apps/tools/debug/trace/trace.h"
#include "util/result.h"

namespace arbiter::tools::debug {

struct DebugError {
  std::string message;
  /// The command or the document is at fault, not GL: a file is not there, say.
  bool isOfUsage = false;
};

/// A condition to stop at: a row's flag, a KIL that discards, an error visible in 8 bits, or a
/// comparison with a written component of a register.
struct Condition {
  enum class Kind { Flag, Kil, Differs, Compare } kind = Kind::Flag;
  enum class Relation { Less, Greater, LessEqual, GreaterEqual, Equal, Unequal };
  unsigned flag = 0;      ///< for Flag
  std::string reg;        ///< for Compare: the name in the program
  unsigned component = 0; ///< for Compare
  Relation relation = Relation::Less;
  float bound = 0;
};

/// Parses "nan", "inf", "over1", "below0", "unwritten", "kil", "differs", or "REG.c<NUMBER" with
/// one of < > <= >= = !=. An error lists the possible words.
[[nodiscard]] Result<Condition, DebugError> parseCondition(std::string_view text);

/// Returns a destination's name without its mask: "result.color" is a name, ".xy" is not part of
/// it.
[[nodiscard]] std::string_view registerName(std::string_view destination);

[[nodiscard]] bool holds(const Condition &condition, const Row &row);

/// Returns the first row from \p from on for which the condition holds.
[[nodiscard]] std::optional<std::size_t> firstRow(const Trace &trace, const Condition &condition,
                                                  std::size_t from = 0);

/// Half a step of 8 bits; smaller errors are invisible.
inline constexpr float kVisible = 0.5f / 255.0f;

} // namespace arbiter::tools::debug
