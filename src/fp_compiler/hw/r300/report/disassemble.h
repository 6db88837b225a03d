#pragma once
#include <string>
#include <string_view>

#include "fp_compiler/hw/r300/check/legality.h"
#include "fp_compiler/hw/r300/machine.h"

namespace arbiter::fp::hw::r300 {

/// The program as the card would hold it, for a person: totals, constants, interpolants, and each
/// node's TEX and pairs. A pair is two lines, of the RGB and of the alpha half: addresses, where
/// the result goes, the operation with its arguments, and after the semicolon the line of \p text
/// that it comes from, with the reason where that is not the instruction itself. An empty text
/// gives numbers of instructions, from 1, instead of lines. Ends with a line break.
///
///     3 rgb   s0=r1 s1=c0 pre=1-s0 r2.xyz =  mad_sat pre.xyz, -s1.xxx, s0.www  ; line 7: LRP
///       alpha s0=r1                o0.w =    rcp |s0.w|                        ; line 9: RCP
///
/// r is a register, c a constant, o a colour target; s0.xyz is RGB address 0, s0.w alpha address 0;
/// pre the presubtract result; _x2 to _x8 and _d2 to _d8 multiply and divide before _sat.
[[nodiscard]] std::string disassemble(const Code &code, const ir::Program &program,
                                      std::string_view text, const Chip &chip = {});

} // namespace arbiter::fp::hw::r300
