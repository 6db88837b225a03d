#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "fp_compiler/back/llvm/code/cpu.h"
#include "fp_compiler/back/llvm/engine/linked.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::llvm_back {

/// The processors that this machine can stand for: itself first, then each lesser family by name.
[[nodiscard]] std::vector<std::string> testedCpus();
/// One of them in the name of a test: "host" for this machine, and nothing that no name may have.
[[nodiscard]] std::string nameInTests(const std::string &cpu);

/// The lanes that code for \p cpu takes for the 2x2 quad of a lane: lower left, lower right, upper
/// left, upper right.
[[nodiscard]] std::array<std::size_t, 4> quadOf(const std::string &cpu, std::size_t lane);

/// A program of any language as code that runs on arrays: attributes in, outputs out, and a mask of
/// what KIL discarded. A texture answers the coordinates (TXP's divided) and TXB's bias or TXL's
/// level, zero where the target takes none, of TXD the difference of the first coordinate's
/// derivatives: so that what reaches a sample is seen.
class TestMachine {
public:
  /// What one lane is run on: a vec4 for each attribute.
  using Attributes = std::vector<ir::Vec4>;
  struct Result {
    std::vector<ir::Vec4> outputs; ///< zero where nothing is written
    bool killed = false;
  };

  /// The program is compiled as it is, without the passes. Check reason() before use.
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
