#pragma once
#include <memory>
#include <string>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::llvm_back {

/// The opcodes whose machine code is within 2^-21.8 of the result, and not equal to it.
[[nodiscard]] bool approximates(ir::Opcode op);

/// Runs programs as machine code and on the interpreter and compares to the bit. Where an opcode's
/// result is an approximation, the interpreter is given the machine code's own value of that one
/// opcode.
class Comparison {
public:
  Comparison(Numerics numerics, const std::string &cpu);
  ~Comparison();

  /// Every component that counts, on attributes and rows made of \p seed: of a wild one, one in
  /// four is special. What the options add to outputs is the caller's and left out.
  /// \return what differs first; empty if nothing does
  [[nodiscard]] std::string run(const ir::Program &program, std::uint64_t seed, bool wild);

  int compared = 0; ///< components
  int killed = 0;   ///< lanes
  /// Lanes left out, as a result was the least normal number: the processor may have made a zero of
  /// it, because it finds one too small before it is rounded to a denormal.
  int edges = 0;

private:
  class Functions;
  Numerics m_numerics;
  std::string m_cpu;
  std::unique_ptr<Functions> m_functions;
};

} // namespace arbiter::fp::llvm_back
