#pragma once
#include <map>
#include <optional>
#include <vector>

#include "fp_compiler/front/bindings/binder.h"
#include "fp_compiler/front/nv/statement.h"

/// Programs of NVIDIA's options as code of the IR, which has no condition codes, no branches and no
/// calls: a write under a condition becomes a CMP of what was there and what is written, a block
/// under IF writes so whatever is in it, a subroutine stands where it is called, and a program that
/// branches backwards is a loop over all of its statements, in which each runs when its turn comes.
namespace arbiter::fp::nv {

/// What NVIDIA's own languages have otherwise than its options: RSQ of what is below zero is NaN in
/// !!FP1.0 and !!VP2.0, and a vertex state program reads what it has written.
struct NativeRules {
  /// A program parameter that is written: its row in Program::parameters, and the number n of c[n].
  struct Row {
    std::uint16_t parameter = 0, number = 0;
  };
  ir::NativeLanguage language = ir::NativeLanguage::None;
  bool vertex = false;               ///< results have values before they are written
  std::map<std::uint16_t, Row> rows; ///< by row of Program::outputs
};

/// Appends the code of \p statements to \p binder's program.
/// \param start the label to begin at; none: the first statement
/// \param sequences what operands and destinations choose from by an address
/// \param rules of the program's language; the options' have no `language`
/// \error flow-control a recursive call, at the call; limit-instructions where calls make more code
///        than any program may have
void lower(const std::vector<Statement> &statements, std::optional<std::uint16_t> start,
           const Sequences &sequences, Binder &binder, Reporter &reporter,
           const NativeRules &rules);

} // namespace arbiter::fp::nv
