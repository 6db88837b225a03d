#pragma once
#include <string>

#include "fp_compiler/ir/interface.h"

namespace arbiter::fp {

/// How to treat unwritten components of a vertex result that has written ones.
enum class PartlyWritten {
  Zero,  ///< write zeros, as the IR defines
  Hosts, ///< leave them to the host, as in the application's own text
};

/// The limits of a host on a program text.
struct AssemblyLimits {
  int instructions = 0;
  int temporaries = 0;
  int parameters = 0; ///< rows
  int addresses = 0;  ///< address registers
};

/// Returns the program as !!ARBvp1.0 or !!ARBfp1.0 text for a host's parser. The form is plain: one
/// list of temporaries, one PARAM for each row, arrays as PARAM arrays with ranges, no aliases, no
/// comments. Numbers have the fewest digits that give the same float. The text writes out what the
/// project defines but the specifications do not: registers that are read before they are written,
/// and partly written results. SWZ reads no constants (constants.h). checkProgram() of the text
/// therefore gives a program of the same meaning.
///
/// \param parts how to treat partly written results of a vertex program
///
/// Requires: validate(program) finds nothing. The language is not AtiFragment, whose colour sum
/// option no assembly language has. Constants are finite, and a vertex program has no _SAT.
[[nodiscard]] std::string emitAssembly(const ir::Program &program,
                                       PartlyWritten parts = PartlyWritten::Zero);

/// Returns the text as above, or an empty string if it exceeds the host's limit on instructions or
/// temporaries.
[[nodiscard]] std::string emitAssembly(const ir::Program &program, PartlyWritten parts,
                                       const AssemblyLimits &most);

/// True if the vertex program reads a conventional attribute and the generic attribute of the same
/// number. ARB text must not bind both.
[[nodiscard]] bool bindsOneTwice(const ir::Program &program);

/// True if emitAssembly() can write the program in an ARB language, whatever its original language.
/// Loops are not allowed, nor opcodes, bindings or constants that only NVIDIA's languages have.
/// Relative operands are not allowed either, because the ARB leaves reads outside an array
/// undefined.
/// \param addresses allow relative operands, because defineAddresses() has run
[[nodiscard]] bool isOfArb(const ir::Program &program, bool addresses = false);

/// Rewrites relative addressing so that it works within the ARB's rules. NVIDIA's languages also
/// define reads outside an array (zero) and addresses that are NaN (0). The rewrite pads arrays
/// with zeros, clamps addresses, and detects NaN by comparisons. Returns false and changes nothing
/// if no text can express this within the limits. Adds up to three temporaries.
[[nodiscard]] bool defineAddresses(ir::Program &program, const AssemblyLimits &most);

} // namespace arbiter::fp
