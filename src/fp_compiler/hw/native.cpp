#include "fp_compiler/hw/native.h"

namespace arbiter::fp::hw {

namespace {

bool within(const ResourceCounts &counts, const ResourceCounts &limits) {
  return counts.instructions <= limits.instructions &&
         counts.aluInstructions <= limits.aluInstructions &&
         counts.texInstructions <= limits.texInstructions &&
         counts.texIndirections <= limits.texIndirections &&
         counts.temporaries <= limits.temporaries && counts.parameters <= limits.parameters &&
         counts.attribs <= limits.attribs && counts.addressRegisters <= limits.addressRegisters;
}

} // namespace

NativeCounts countNative(const ir::Program &, const ResourceCounts &api, const Limits &limits) {
  return {api, within(api, limits.native)};
}

NativeReport explainNative(const ir::Program &program, const ResourceCounts &api,
                           const Limits &limits) {
  NativeReport report;
  const NativeCounts native = countNative(program, api, limits);
  report.counts = native.counts;
  report.fits = native.fits;
  return report;
}

} // namespace arbiter::fp::hw
