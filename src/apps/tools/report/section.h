#pragma once
#include <string>

#include "apps/tools/report/program_set.h"

/// Writes the section of a report's page about one program.
namespace arbiter::tools {

/// Returns the id of a program's section: "p3" for the third. Its line 17 is "p3-17".
[[nodiscard]] std::string anchor(std::size_t program);

/// Returns the verdict as HTML with its sign and color, for any cell.
[[nodiscard]] std::string verdictMark(Verdict verdict);

/// Returns the lines of instructions as links into the section's source: "lines 3, 7-9". Returns ""
/// without instructions.
[[nodiscard]] std::string lineLinks(const ProgramSet &set, std::size_t index,
                                    const std::vector<std::uint32_t> &instructions);

/// Returns "ALU instructions 70 of 64 (by the API 68 of 64)" for each limit that the program
/// exceeds, as HTML. Empty if it fits. The API's limits appear only if they make the program
/// invalid.
[[nodiscard]] std::vector<std::string> excesses(const ReportedProgram &program);

/// Returns a folded section about the program: gauges, reasons, nodes, chain, cycles, source with
/// costs and diagnostics, and disassembly. A captured program also has its parameters and textures.
/// Parts that the NativeReport lacks are left out.
/// \param index of the program in `set`
[[nodiscard]] std::string programSection(const ProgramSet &set, std::size_t index);

} // namespace arbiter::tools
