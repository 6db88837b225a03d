#include "state/host_draw/linking/host_objects.h"

#include <algorithm>

#include "fp_compiler/back/assembly/assembly.h"
#include "fp_compiler/emit.h"
#include "fp_compiler/ir/ir.h"
#include "fp_compiler/ir/reads.h"
#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/host_draw/draw_context.h"
#include "state/host_draw/linking/host_assembly.h"
#include "state/host_draw/linking/undefined_results.h"
#include "state/host_draw/stages/stage_pipeline.h"
#include "state/objects/linked_program.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

/// Returns the info log of a shader or program.
template <typename GetIv, typename GetLog>
std::string infoLog(GLuint object, GetIv getIv, GetLog getLog) {
  GLint length = 0;
  getIv(object, GL_INFO_LOG_LENGTH, &length);
  if (length <= 0)
    return {};
  std::string text(std::size_t(length), '\0');
  GLsizei written = 0;
  getLog(object, length, &written, text.data());
  text.resize(std::size_t(std::clamp<GLsizei>(written, 0, length)));
  return text;
}

std::string nameOf(const ProgramPair &pair) {
  std::string name;
  for (const auto &compiled : {pair.vertex, pair.fragment})
    if (compiled)
      name += (name.empty() ? "" : " with ") + toHex(compiled->hash);
  return name;
}

} // namespace

GLuint compileShader(DrawContext &context, const CompiledProgram &compiled,
                     const std::string &glsl) {
  const host::HostTable &host = *context.host;
  const GLuint shader =
      host.CreateShader(isVertex(compiled) ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
  if (shader == 0)
    return 0;
  const GLchar *const text = glsl.c_str();
  const auto length = GLint(glsl.size());
  host.ShaderSource(shader, 1, &text, &length);
  host.CompileShader(shader);
  GLint status = GL_FALSE;
  host.GetShaderiv(shader, GL_COMPILE_STATUS, &status);
  if (status == GL_TRUE)
    return shader;
  logError("state", "the host does not compile the GLSL of program %s:\n%s",
           toHex(compiled.hash).c_str(),
           infoLog(shader, host.GetShaderiv, host.GetShaderInfoLog).c_str());
  host.DeleteShader(shader);
  return 0;
}

GLuint linkProgram(DrawContext &context, const ProgramPair &pair, GLuint vertex, GLuint fragment) {
  const host::HostTable &host = *context.host;
  const GLuint program = host.CreateProgram();
  if (program == 0)
    return 0;
  if (pair.vertex)
    for (const fp::GlslAttribute &attribute : pair.vertex->glsl.attributes)
      host.BindAttribLocation(program, attribute.index, attribute.name.c_str());
  for (const GLuint shader : {vertex, fragment})
    if (shader != 0)
      host.AttachShader(program, shader);
  if (stagesStandApart(context) && (vertex == 0 || fragment == 0))
    host.ProgramParameteri(program, GL_PROGRAM_SEPARABLE, GL_TRUE);
  host.LinkProgram(program);
  for (const GLuint shader : {vertex, fragment})
    if (shader != 0)
      host.DetachShader(program, shader);
  GLint status = GL_FALSE;
  host.GetProgramiv(program, GL_LINK_STATUS, &status);
  if (status == GL_TRUE)
    return program;
  logError("state", "the host does not link the GLSL of program %s:\n%s", nameOf(pair).c_str(),
           infoLog(program, host.GetProgramiv, host.GetProgramInfoLog).c_str());
  host.DeleteProgram(program);
  return 0;
}

namespace {

/// Returns the limits of the host's vertex programs: the smaller of what its parser accepts and
/// what it runs natively.
fp::AssemblyLimits hostAssemblyLimits(const host::HostTable &host) {
  const auto most = [&](GLenum limit, GLenum nativeLimit) {
    GLint all = 0, native = 0;
    host.GetProgramivARB(GL_VERTEX_PROGRAM_ARB, limit, &all);
    host.GetProgramivARB(GL_VERTEX_PROGRAM_ARB, nativeLimit, &native);
    return native > 0 ? std::min(all, native) : all;
  };
  return {
      .instructions = most(GL_MAX_PROGRAM_INSTRUCTIONS_ARB, GL_MAX_PROGRAM_NATIVE_INSTRUCTIONS_ARB),
      .temporaries = most(GL_MAX_PROGRAM_TEMPORARIES_ARB, GL_MAX_PROGRAM_NATIVE_TEMPORARIES_ARB),
      .parameters = most(GL_MAX_PROGRAM_PARAMETERS_ARB, GL_MAX_PROGRAM_NATIVE_PARAMETERS_ARB),
      .addresses =
          most(GL_MAX_PROGRAM_ADDRESS_REGISTERS_ARB, GL_MAX_PROGRAM_NATIVE_ADDRESS_REGISTERS_ARB)};
}

/// Returns the ARB text of a program in NVIDIA's languages, if the passes leave only what ARB can
/// express. Hosts take less time for that than for GLSL, which they link with each fragment
/// program. Returns an empty text otherwise.
std::string textOfNvidias(const DrawContext &context, const CompiledProgram &compiled,
                          const std::vector<fp::ir::Output> &defined) {
  if (!isVertex(compiled))
    return {};
  fp::ir::Program program = withResults(*compiled.program, defined);
  const fp::AssemblyLimits most = hostAssemblyLimits(*context.host);
  const bool isOfArb = fp::defineAddresses(program, most) && fp::isOfArb(program, true);
  return isOfArb ? fp::emitAssembly(program, fp::PartlyWritten::Zero, most) : std::string();
}

/// Returns the program with its colours clamped when they are written. Fog applies to the clamped
/// colour (ARB_fragment_program 3.11.4.5.1), but NVIDIA's driver applies it before clamping.
fp::ir::Program withClampedColors(fp::ir::Program program) {
  for (fp::ir::Instruction &instruction : program.code)
    if (instruction.dst.file == fp::ir::File::Output && fp::ir::writeMask(instruction) != 0 &&
        program.outputs[instruction.dst.index].kind == fp::ir::OutputKind::Color)
      instruction.dst.saturate = true;
  return program;
}

std::string assemblyText(const DrawContext &context, const CompiledProgram &compiled,
                         const std::vector<fp::ir::Output> &defined) {
  if (isVertex(compiled) && !compiled.clipped)
    return {}; // a clipped variant clips by itself, which the host's assembly cannot
  if (!compiled.program || compiled.program->language == fp::ir::Language::AtiFragment)
    return compiled.source(); // a variant of an ATI shader, already emitted as assembly
  if (compiled.program->options.nv != fp::ir::NvOption::None)
    return textOfNvidias(context, compiled, defined);
  if (isVertex(compiled) && fp::bindsOneTwice(*compiled.program))
    return {};
  if (compiled.program->options.fog != fp::ir::FogMode::None)
    return fp::emitAssembly(withClampedColors(*compiled.program));
  // NVIDIA's driver gives (0, 0, 0, 1) for components that are never written, and programs divide
  // by that w. Over a software host, the rasterizer and the host take turns, so both use zeros.
  const auto parts = context.caps.onProcessor ? fp::PartlyWritten::Zero : fp::PartlyWritten::Hosts;
  return defined.empty() ? fp::emitAssembly(*compiled.program, parts)
                         : fp::emitAssembly(withResults(*compiled.program, defined), parts);
}

} // namespace

GLuint loadAssembly(DrawContext &context, const CompiledProgram &compiled,
                    const std::vector<fp::ir::Output> &defined) {
  const GLenum target = hostAssemblyTarget(compiled);
  const std::string text = assemblyText(context, compiled, defined);
  if (text.empty())
    return 0;
  const host::HostTable &host = *context.host;
  GLuint name = 0;
  HostErrorScope scope(*context.host, context.errors.pending);
  host.GenProgramsARB(1, &name);
  host.BindProgramARB(target, name);
  host.ProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()), text.data());
  const bool refused = scope.failed();
  context.hostSide.assembly->bindAgain(context, target);
  if (!refused)
    return name;
  logWarn("state", "the host's own compiler refuses program %s", toHex(compiled.hash).c_str());
  host.DeleteProgramsARB(1, &name);
  return 0;
}

} // namespace arbiter::state
