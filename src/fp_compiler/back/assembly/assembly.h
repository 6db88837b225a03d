#pragma once
#include <string>

#include "fp_compiler/ir/interface.h"

namespace arbiter::fp {

/// The components of a vertex result that nothing writes, where others are written.
enum class PartlyWritten {
  Zero,  ///< written out, as the IR has them
  Hosts, ///< left to the host, as they are in the application's own text
};

/// What a host takes of a text.
struct AssemblyLimits {
  int instructions = 0;
  int temporaries = 0;
  int parameters = 0; ///< rows
  int addresses = 0;  ///< address registers
};

/// The program as !!ARBvp1.0 or !!ARBfp1.0 text in one plain form, for a host's own parser: one
/// list of temporaries, a PARAM a row, arrays as PARAM arrays with ranges, no aliases, no comments.
/// Numbers are the shortest that give the same float. What this project defines and the
/// specifications do not (registers that are read before they are written, results that are partly
/// written) is written out, so that the host reads the text as the IR says; checkProgram() of it
/// means the same program.
///
/// \param parts what becomes of results of a vertex program that are partly written
///
/// Requires: validate(program) finds nothing; the language is not AtiFragment, whose option of a
/// colour sum no assembly language has; constants are finite; a vertex program has no _SAT.
[[nodiscard]] std::string emitAssembly(const ir::Program &program,
                                       PartlyWritten parts = PartlyWritten::Zero);

/// The same, and empty if it has more instructions or temporaries than a host takes: those of the
/// program, and what the text needs beside them.
[[nodiscard]] std::string emitAssembly(const ir::Program &program, PartlyWritten parts,
                                       const AssemblyLimits &most);

/// True if the vertex program reads a conventional attribute and the generic one of its number,
/// which no text may bind both.
[[nodiscard]] bool bindsOneTwice(const ir::Program &program);

/// True where the text of emitAssembly() is one of the ARB's language, whatever language the
/// program was written in: it has no loops, and no opcodes, bindings or constants that only
/// NVIDIA's have. Rows by address are none of them, as the ARB leaves undefined what lies beside an
/// array.
/// \param addresses they are, for defineAddresses() has been there
[[nodiscard]] bool isOfArb(const ir::Program &program, bool addresses = false);

/// Has rows read by address as the ARB defines them, and what NVIDIA's languages have beyond: zeros
/// lie beside the arrays, addresses are held to these, and 0 is loaded of what is no number by
/// comparisons that it fails. False, and nothing is changed, where no text can say so, or none with
/// so few rows and address registers. Up to three temporaries are added.
[[nodiscard]] bool defineAddresses(ir::Program &program, const AssemblyLimits &most);

} // namespace arbiter::fp
