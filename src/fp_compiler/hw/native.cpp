#include "fp_compiler/hw/native.h"

#include "fp_compiler/hw/cycles.h"
#include "fp_compiler/hw/dataflow.h"
#include "fp_compiler/hw/i915/i915.h"
#include "fp_compiler/hw/nv30/nv30.h"
#include "fp_compiler/hw/r300/compile.h"
#include "fp_compiler/hw/r300/report/disassemble.h"
#include "fp_compiler/hw/r300/report/report.h"

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

/// Returns the model for the program. Models count ARB fragment programs only. Other languages get
/// the API's counts, and so do programs under NVIDIA's options, whose instructions are the chip's
/// own.
NativeModel modelOf(const ir::Program &program, const Limits &limits) {
  const bool arb =
      program.language == ir::Language::ArbFragment && program.options.nv == ir::NvOption::None;
  return arb ? limits.nativeModel : NativeModel::Documented;
}

NativeCounts countOf(const SlotProgram &code, const ResourceCounts &api, const Limits &limits,
                     std::uint32_t interpolators) {
  const ResourceCounts counts = countSlots(code, api.texIndirections);
  return {counts, within(counts, limits.native) && code.interpolators <= interpolators};
}

NativeReport reportOf(NativeModel model, const NativeCounts &native) {
  NativeReport report;
  report.model = model;
  report.counts = native.counts;
  report.fits = native.fits;
  return report;
}

r300::Code compileR300(const ir::Program &program, const Limits &limits) {
  return r300::compile(program, {.scaleRectangles = limits.scaleRectangles != 0});
}

NativeCounts countOf(const r300::Code &code, const Limits &limits) {
  const ResourceCounts counts = r300::counts(code);
  return {counts, within(counts, limits.native) && code.interpolators <= r300::kInterpolators};
}

NativeReport explainR300(const ir::Program &program, const Limits &limits, std::string_view text) {
  const r300::Code code = compileR300(program, limits);
  NativeReport report = reportOf(NativeModel::R300, countOf(code, limits));
  r300::report(report, program, code);
  report.cycles = estimateR300(code);
  const ResourceCounts &sizes = limits.native;
  report.disassembly = r300::disassemble(code, program, text,
                                         {.pairs = sizes.aluInstructions,
                                          .textures = sizes.texInstructions,
                                          .nodes = sizes.texIndirections,
                                          .temporaries = sizes.temporaries,
                                          .constants = sizes.parameters,
                                          .interpolators = r300::kInterpolators});
  return report;
}

constexpr std::uint32_t kAnyInterpolators = 0xFFFFFFFF; ///< the limit of attributes decides

constexpr SlotWords kNv30Words = {"", nv30::expansionOf};
constexpr SlotWords kI915Words = {"phase", i915::expansionOf};

NativeReport explainNv30(const ir::Program &program, const ResourceCounts &api,
                         const Limits &limits, std::string_view text) {
  const SlotProgram code = nv30::translate(program);
  NativeReport report = reportOf(limits.nativeModel, countOf(code, api, limits, kAnyInterpolators));
  reportSlots(report, program, code, kNv30Words);
  report.cycles = estimateNv30(code, limits.nativeModel);
  report.disassembly = listSlots(program, code, kNv30Words, text);
  return report;
}

NativeReport explainI915(const ir::Program &program, const ResourceCounts &api,
                         const Limits &limits, std::string_view text) {
  const SlotProgram code = i915::translate(program);
  NativeReport report =
      reportOf(NativeModel::I915, countOf(code, api, limits, i915::kTextureCoordinates));
  reportSlots(report, program, code, kI915Words);
  report.cycles = estimateI915(code);
  report.disassembly = listSlots(program, code, kI915Words, text);
  return report;
}

} // namespace

NativeCounts countNative(const ir::Program &program, const ResourceCounts &api,
                         const Limits &limits) {
  switch (modelOf(program, limits)) {
  case NativeModel::Nv30:
  case NativeModel::Nv35:
    return countOf(nv30::translate(program), api, limits, kAnyInterpolators);
  case NativeModel::I915:
    return countOf(i915::translate(program), api, limits, i915::kTextureCoordinates);
  case NativeModel::R300:
    return countOf(compileR300(program, limits), limits);
  case NativeModel::Documented:
    break;
  }
  return {api, within(api, limits.native)};
}

NativeReport explainNative(const ir::Program &program, const ResourceCounts &api,
                           const Limits &limits, std::string_view text) {
  switch (modelOf(program, limits)) {
  case NativeModel::Nv30:
  case NativeModel::Nv35:
    return explainNv30(program, api, limits, text);
  case NativeModel::I915:
    return explainI915(program, api, limits, text);
  case NativeModel::R300:
    return explainR300(program, limits, text);
  case NativeModel::Documented:
    break;
  }
  NativeReport report = reportOf(NativeModel::Documented, countNative(program, api, limits));
  report.chain = longestChain(program, dataflowOf(program)); // it needs no model
  return report;
}

} // namespace arbiter::fp::hw
