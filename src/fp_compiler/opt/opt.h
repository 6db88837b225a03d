#pragma once
#include "fp_compiler/opt/ir_names.h"

/// Optimisation passes. Each pass requires a program that ir::validate() accepts and leaves a valid
/// one. It preserves the program's meaning to the bit (ir/semantics.h; all NaNs are equal) in the
/// given mode, or in every mode if it takes none. It runs in linear time. It returns true if it
/// changed anything, and a second run changes nothing. Register numbers stay the same;
/// foldConstants() may append parameters.
namespace arbiter::fp::opt {

/// Evaluates instructions with constant operands, using the interpreter's arithmetic. Infinite and
/// NaN results are left for the host to compute.
[[nodiscard]] bool foldConstants(ir::Program &program, Numerics numerics = Numerics::Host);

/// Replaces reads of a copy (MOV, SWZ without _SAT) by reads of its source, and composes swizzles
/// and signs. Reads of components that were never written become reads of zero.
[[nodiscard]] bool propagateCopies(ir::Program &program);

/// Replaces an instruction by a copy if an earlier one computed the same value and the register
/// still holds it. This includes texture samples.
[[nodiscard]] bool shareExpressions(ir::Program &program);

/// Rewrites instructions by identities that hold for every value, including NaN, infinity and -0:
/// x*1, x-0, MAD by 1, CMP of a constant, POW by 0, MAX(x, x), signs under ABS. The identities hold
/// in every mode, but the value of a constant depends on the mode.
[[nodiscard]] bool simplify(ir::Program &program, Numerics numerics = Numerics::Host);

/// Replaces relative operands with a constant address by their row.
[[nodiscard]] bool resolveAddresses(ir::Program &program, Numerics numerics = Numerics::Host);

/// Removes write mask components that nothing reads, and instructions that then write nothing.
[[nodiscard]] bool removeDeadCode(ir::Program &program);

/// Unrolls loops that have a constant count and no BRK. A loop that would become too long stays.
/// All loops stay if together they would become too long, or if they may reach the cap on
/// iterations.
[[nodiscard]] bool unrollLoops(ir::Program &program);

/// Rewrites a program with loops as straight-line code, if it stays short. Iteration counts may be
/// constants that the program computes from others. Where a BRK does not depend on constants,
/// selects replace it.
[[nodiscard]] bool followLoops(ir::Program &program, Numerics numerics = Numerics::Host);

/// Describes how a target handles the fog options.
struct OptionTarget {
  /// True if the target applies fog itself, after the program. The program then keeps the option.
  bool hasFog = false;
  /// True if fog coordinates may be negative distances (GlslHost::negativeFogDistances). The factor
  /// is then that of the absolute value.
  bool hasNegativeFogDistances = false;
};

/// Replaces the program's colour sum and fog options by instructions at its end, which read the
/// attributes and the state that the options read. Colours are collected in temporaries. It is not
/// one of run()'s passes, and adds attributes, parameters and temporaries. Back ends that write
/// code call it first. Models of cards count the options as they are, because each card has its own
/// instructions for them.
bool lowerOptions(ir::Program &program, const OptionTarget &target = {});

/// Runs all passes until nothing changes, or up to a maximum number of rounds.
void run(ir::Program &program, Numerics numerics = Numerics::Host);

} // namespace arbiter::fp::opt
