#include "fp_compiler/compilation.h"

#include <cstring>

#include "fp_compiler/front/diagnostic_ids.h"
#include "fp_compiler/ir/fields.h"
#include "fp_compiler/ir/validate.h"

namespace arbiter::fp {

// A new member does not compile here until it is in its structure's list (ir/fields.h).
FP_FIELDS(ResourceCounts, a, b, c, d, e, f, g, h)
/// Limits are part of a key, so they are written and never read.
void fields(ArchiveWriter &archive, Limits &value) {
  auto &[api, native, locals, envs, coords, images, units, matrices, depth, lights, buffers,
         palette, indirections, atiRange, vertexUnits, clipPlanes, vertexAttribs, nvOptions,
         nvVertexProgram, model, rectangles, combiners, stageConstants, textureShaders, card] =
      value;
  archive(api, native, locals, envs, coords, images, units, matrices, depth, lights, buffers,
          palette, indirections, atiRange, vertexUnits, clipPlanes, vertexAttribs, nvOptions,
          nvVertexProgram, model, rectangles, combiners, stageConstants, textureShaders,
          std::string_view(card));
}
FP_FIELDS(CompileOptions, limits, policy, numerics)
FP_FIELDS(GlslHost, rectangle, conventions, buffers, clipPlanes, clipDistances, alphaDepths,
          spriteUnits, spriteS, bitEncoding, negativeFogDistances)
FP_FIELDS(GlslSampler, uniform, unit, target)
FP_FIELDS(GlslUniform, parameter)
FP_FIELDS(GlslAttribute, name, index)
FP_FIELDS(GlslShader, text, uniforms, samplers, attributes, writesDepth, kills)
FP_FIELDS(NamedParameter, name, local, initial)
FP_FIELDS(NativeInterface, language, named, constants, attributes, rowsRead, readsAny, rowsWritten)
FP_FIELDS(CheckResult, diagnostics, program, counts, nativeCounts, underNative, native)
FP_FIELDS(Compilation, check, glsl)

/// An ID is a pointer into the table of diagnostics. It is written as text and looked up on
/// reading.
void fields(ArchiveWriter &archive, Diagnostic &value) {
  auto &[severity, id, span, message, hint] = value;
  archive(severity, std::string_view(id), span, message, hint);
}
void fields(ArchiveReader &archive, Diagnostic &value) {
  auto &[severity, id, span, message, hint] = value;
  std::string name;
  archive(severity, name, span, message, hint);
  for (const DiagnosticInfo &row : diagnosticTable()) {
    if (name == row.id) {
      id = row.id;
      return;
    }
  }
  archive.fail();
}

Compilation compile(const CompilationInput &input, std::string_view text) {
  Compilation result;
  result.check = checkProgram(input.language, text, input.options);
  const bool draws = input.language != ir::Language::AtiFragment &&
                     result.check.native.language != ir::NativeLanguage::Vsp1;
  if (!result.check.ok() || !draws)
    return result;
  // Tracing a loop takes longer than everything else when a load finds its code in a cache. For
  // programs of NVIDIA's languages, every load asks for the optimised program.
  const ir::Program &program = *result.check.program;
  if (input.numerics == Numerics::Host &&
      (program.options.nv != ir::NvOption::None || ir::hasLoops(program)))
    optimise(*result.check.program);
  result.glsl = emitGlsl(*result.check.program, input.host, input.numerics);
  return result;
}

std::string cacheKey(const CompilationInput &input, std::string_view text) {
  ArchiveWriter archive;
  archive(input.language, input.options, input.host, input.numerics, text);
  return archive.take();
}

std::string serialise(const Compilation &compilation) {
  ArchiveWriter archive;
  archive(compilation);
  return archive.take();
}

std::optional<Compilation> deserialise(std::string_view bytes) {
  ArchiveReader archive(bytes);
  std::optional<Compilation> result(std::in_place);
  archive(*result);
  if (!archive.complete() || (result->check.ok() && !ir::validate(*result->check.program).empty()))
    return std::nullopt;
  return result;
}

} // namespace arbiter::fp
