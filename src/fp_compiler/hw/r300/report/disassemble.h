#pragma once
#include <string>
#include <string_view>

#include "fp_compiler/hw/r300/check/legality.h"
#include "fp_compiler/hw/r300/machine.h"

namespace arbiter::fp::hw::r300 {

/// Returns a listing of the program: totals, constants, interpolants, and each node's TEX and
/// pairs. A pair is two lines, one for the RGB and one for the alpha half. A line has the
/// addresses, the destination, and the operation with its arguments. After the semicolon is the
/// line of \p text that it comes from, with the reason if it is not the instruction itself. Without
/// a text there are instruction numbers, from 1. The listing ends with a line break.
///
///     3 rgb   s0=r1 s1=c0 pre=1-s0 r2.xyz =  mad_sat pre.xyz, -s1.xxx, s0.www  ; line 7: LRP
///       alpha s0=r1                o0.w =    rcp |s0.w|                        ; line 9: RCP
///
/// r is a register, c a constant, o a colour target. s0.xyz is RGB address 0, and s0.w alpha
/// address 0. pre is the presubtract result. _x2 to _x8 and _d2 to _d8 multiply and divide before
/// _sat.
[[nodiscard]] std::string disassemble(const Code &code, const ir::Program &program,
                                      std::string_view text, const Chip &chip = {});

} // namespace arbiter::fp::hw::r300
