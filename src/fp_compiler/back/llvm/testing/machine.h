#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "fp_compiler/back/llvm/code/cpu.h"
#include "fp_compiler/back/llvm/engine/linked.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::llvm_back {

/// Returns the processor types that this machine can run: itself first, then each lesser family by
/// name.
[[nodiscard]] std::vector<std::string> testedCpus();
/// Returns a processor type in a form that test names allow; "host" for this machine.
[[nodiscard]] std::string nameInTests(const std::string &cpu);

/// Returns the lanes of the 2x2 quad of a lane in code for \p cpu: lower left, lower right, upper
/// left, upper right.
[[nodiscard]] std::array<std::size_t, 4> quadOf(const std::string &cpu, std::size_t lane);

/// A program of any language as code that runs on arrays: attributes in, outputs out, and a mask of
/// what KIL discarded. A texture returns its operands, so that tests see what reaches a sample.
/// These are the coordinates (divided for TXP), and TXB's bias or TXL's level. Values that the
/// target does not use are zero. For TXD it is the difference of the first coordinate's
/// derivatives.
class TestMachine {
public:
  /// The input of one lane: a vec4 for each attribute.
  using Attributes = std::vector<ir::Vec4>;
  struct Result {
    std::vector<ir::Vec4> outputs; ///< zero if nothing is written
    bool killed = false;
  };

  /// Compiles the program without the passes. Check reason() before use.
  TestMachine(const ir::Program &program, Numerics numerics, const std::string &cpu);
  [[nodiscard]] const std::string &reason() const { return m_reason; }

  /// \param parameters one row for each of Program::parameters
  [[nodiscard]] std::vector<Result> run(const std::vector<Attributes> &lanes,
                                        const std::vector<ir::Vec4> &parameters) const;

private:
  const ir::Program &m_program;
  std::string m_reason;
  std::unique_ptr<Linked> m_code;
};

} // namespace arbiter::fp::llvm_back
