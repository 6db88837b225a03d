#pragma once
#include <string>

#include "tools/report/program_set.h"

/// What a report's page says of one program.
namespace arbiter::tools {

/// "p3" for the third: its section's id; "p3-17" is its line 17.
[[nodiscard]] std::string anchor(std::size_t program);

/// The verdict with its sign and colour, for any cell.
[[nodiscard]] std::string verdictMark(Verdict verdict);

/// The lines of instructions as links to the section's source: "lines 3, 7-9". Empty without any.
[[nodiscard]] std::string lineLinks(const ProgramSet &set, std::size_t index,
                                    const std::vector<std::uint32_t> &instructions);

/// "ALU instructions 70 of 64 (by the API 68 of 64)" for each limit that it is over; empty if it
/// fits. The API's are named where they refuse it. HTML.
[[nodiscard]] std::vector<std::string> excesses(const ReportedProgram &program);

/// A folded section with all that is known of the program: gauges, reasons, nodes, chain, cycles,
/// source with costs and diagnostics, disassembly, and of a capture what it was drawn with. Any
/// part that the NativeReport lacks is left out.
/// \param index of the program in `set`
[[nodiscard]] std::string programSection(const ProgramSet &set, std::size_t index);

} // namespace arbiter::tools
