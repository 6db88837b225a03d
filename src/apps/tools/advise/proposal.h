#pragma once
#include <string>
#include <vector>

#include "apps/tools/advise/edit.h"
#include "fp_compiler/ir/ir.h"

/// A change of the text that a rule proposes, before it is measured and tested.
namespace arbiter::tools::advise {

/// The required equality of a rewritten program's results. Rounding allows another order of sums
/// and products, and other approximations of functions; see near() of trial.h.
enum class Nearness : std::uint8_t { Exact, Rounding };

/// An input that the rewritten program has in addition, and that the application must provide. Its
/// value is a register's value in the original program.
struct Derived {
  enum class Kind : std::uint8_t { Local, TexCoord, Texture };
  Kind kind = Kind::Local;
  std::uint8_t index = 0; ///< number of the local parameter, texture coordinate set or image unit
  /// The value is the result of this instruction, or its operand `operand`.
  std::uint32_t instruction = 0;
  int operand = kResult;
  static constexpr int kResult = -1;
};

struct Proposal {
  const char *rule = ""; ///< stable, kebab-case: "select_by_cmp"; listed in docs/write/advice.md
  fp::Span span;         ///< the place in the text
  std::string message;   ///< one line, no full stop
  Edits edits;           ///< sorted; empty for advice that cannot be measured
  Nearness nearness = Nearness::Exact;
  /// Set for advice; the edits are then a sketch, for measuring.
  std::vector<Derived> derived;
  /// For advice: the application's part, "set program.local[1] to ...".
  std::string application;
  /// For advice: a condition for the edits that only the author can judge.
  std::string condition;
  /// True if work moves into a texture; a smaller sum of slots is then enough.
  bool texture = false;
};
using Proposals = std::vector<Proposal>;

} // namespace arbiter::tools::advise
