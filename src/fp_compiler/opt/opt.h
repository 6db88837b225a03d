#pragma once
#include "fp_compiler/ir/ir.h"

/// The passes. Each requires a program that ir::validate() accepts and leaves one; keeps its
/// meaning to the bit (ir/semantics.h; all NaNs are one) in the mode that it is given, or in every
/// mode if it takes none; runs in time linear in the program; returns true if it changed anything,
/// and false when it is run again at once. Register numbers stay as they are; foldConstants() may
/// append parameters.
namespace arbiter::fp::opt {

/// Computes instructions whose operands are all constant, with the interpreter's own arithmetic.
/// A result that is infinite or NaN is left to the host.
[[nodiscard]] bool foldConstants(ir::Program &program, Numerics numerics = Numerics::Host);

/// Makes reads of a copy (MOV, SWZ without _SAT) reads of its source, composing swizzles and signs;
/// reads of components that were never written become reads of zero.
[[nodiscard]] bool propagateCopies(ir::Program &program);

/// Makes an instruction that computes what another one has computed, and that is still there, a
/// copy of it. Texture samples count.
[[nodiscard]] bool shareExpressions(ir::Program &program);

/// Rewrites instructions by identities that hold for every value, NaN, infinity and -0 included:
/// x*1, x-0, MAD by 1, CMP of a constant, POW by 0, MAX(x, x), signs under ABS. The identities hold
/// in every mode, as registers hold the mode's numbers; what a constant is depends on the mode.
[[nodiscard]] bool simplify(ir::Program &program, Numerics numerics = Numerics::Host);

/// Makes operands that are read by a constant address reads of their row.
[[nodiscard]] bool resolveAddresses(ir::Program &program, Numerics numerics = Numerics::Host);

/// Drops write mask components that nothing reads, and instructions that write none.
[[nodiscard]] bool removeDeadCode(ir::Program &program);

/// Writes the code of a loop as often as it runs, where a constant says how often and no BRK leaves
/// it. One that would be too long stays, as do all of them if they would be too long together, or
/// may come to the cap on iterations.
[[nodiscard]] bool unrollLoops(ir::Program &program);

/// Writes a program with loops as one without, if it stays short: as often as constants say, which
/// may be those that the program computes of others, and with selects behind each BRK that they do
/// not decide.
[[nodiscard]] bool followLoops(ir::Program &program, Numerics numerics = Numerics::Host);

/// All of them, until nothing moves, or until a long program has had its share of rounds.
void run(ir::Program &program, Numerics numerics = Numerics::Host);

} // namespace arbiter::fp::opt
