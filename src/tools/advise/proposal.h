#pragma once
#include <string>
#include <vector>

#include "fp_compiler/ir/ir.h"
#include "tools/advise/edit.h"

/// What rules say: a change of the text that is still to be measured and tried.
namespace arbiter::tools::advise {

/// How near the results of a rewritten program must be. Rounding: sums and products may be taken in
/// another order, functions may be computed in another way; see near() of trial.h.
enum class Nearness : std::uint8_t { Exact, Rounding };

/// An input that the rewritten program has and the original has not: what the application would
/// have to give. Its value is what the original has in a register.
struct Derived {
  enum class Kind : std::uint8_t { Local, TexCoord, Texture };
  Kind kind = Kind::Local;
  std::uint8_t index = 0; ///< of the local parameter, texture coordinate set or image unit
  /// The result of this instruction; or, of one that is read and not computed, this operand of it.
  std::uint32_t instruction = 0;
  int operand = kResult;
  static constexpr int kResult = -1;
};

struct Proposal {
  const char *rule = ""; ///< stable, kebab-case: "select-by-cmp"; listed in docs/write/advice.md
  fp::Span span;         ///< what it is about
  std::string message;   ///< one line, no full stop
  Edits edits;           ///< sorted; empty: nothing can be measured, advice alone
  Nearness nearness = Nearness::Exact;
  /// Not empty: advice. The edits are then a sketch, by which it is measured.
  std::vector<Derived> derived;
  /// Of advice: what the application does, "set program.local[1] to ...".
  std::string application;
  /// Of advice whose edits hold under a condition that only the author knows.
  std::string condition;
  /// A texture takes the work over: it is enough that there are fewer slots in all.
  bool texture = false;
};
using Proposals = std::vector<Proposal>;

} // namespace arbiter::tools::advise
