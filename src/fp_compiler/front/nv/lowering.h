#pragma once
#include <map>
#include <optional>
#include <vector>

#include "fp_compiler/front/bindings/binder.h"
#include "fp_compiler/front/nv/statement.h"

/// Lowers programs under NVIDIA's options to the IR, which has no condition codes, branches or
/// calls. A conditional write becomes a CMP of the old and the new value, and so does every write
/// inside an IF. Subroutines are inlined. A program that branches backwards becomes a loop over all
/// its statements, and each runs in its turn.
namespace arbiter::fp::nv {

/// The rules of NVIDIA's own languages that differ from its options. In !!FP1.0 and !!VP2.0, RSQ of
/// a negative number is NaN. A vertex state program can read what it has written.
struct NativeRules {
  /// A program parameter that is written: its row in Program::parameters, and n of c[n].
  struct Row {
    std::uint16_t parameter = 0, number = 0;
  };
  ir::NativeLanguage language = ir::NativeLanguage::None;
  bool vertex = false;               ///< results have values before they are written
  std::map<std::uint16_t, Row> rows; ///< by row of Program::outputs
};

/// Appends the code of \p statements to \p binder's program.
/// \param start the label to begin at; without one the first statement
/// \param sequences the attributes and results that addresses select from
/// \param rules of the program's language; `language` is None for the options
/// \error flow_control a recursive call, at the call; limit_instructions if inlined calls make more
/// code than any program may have
void lower(const std::vector<Statement> &statements, std::optional<std::uint16_t> start,
           const Sequences &sequences, Binder &binder, Reporter &reporter,
           const NativeRules &rules);

} // namespace arbiter::fp::nv
