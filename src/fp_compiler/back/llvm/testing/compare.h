#pragma once
#include <memory>
#include <string>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::llvm_back {

/// True for opcodes whose machine code is approximate: within 2^-21.8 of the result.
[[nodiscard]] bool approximates(ir::Opcode op);

/// Runs programs as machine code and in the interpreter, and compares the results to the bit. For
/// approximate opcodes, the interpreter takes the result of the machine code for that opcode.
class Comparison {
public:
  Comparison(Numerics numerics, const std::string &cpu);
  ~Comparison();

  /// Compares every relevant component, with attributes and rows generated from \p seed. For a wild
  /// program, one number in four is special. Effects of options on outputs are left to the caller.
  /// \return the first difference; empty if there is none
  [[nodiscard]] std::string run(const ir::Program &program, std::uint64_t seed, bool wild);

  int compared = 0; ///< number of components
  int killed = 0;   ///< number of lanes
  /// Number of lanes left out because a result was the least normal number. The processor may flush
  /// it to zero, because it detects underflow before rounding.
  int edges = 0;

private:
  class Functions;
  Numerics m_numerics;
  std::string m_cpu;
  std::unique_ptr<Functions> m_functions;
};

} // namespace arbiter::fp::llvm_back
