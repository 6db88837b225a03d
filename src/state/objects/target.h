#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/ir/interface.h"
#include "fp_compiler/limits.h"
#include "fp_compiler/native_interface.h"
#include "state/objects/program_object.h"

namespace arbiter::state {

/// The properties of a program target, the same in every context.
struct TargetInfo {
  /// The enum for Enable and for the program API. AtiApi, Combiners, TextureShaders and
  /// VertexShader have no entry points of that API.
  GLenum name;
  fp::ir::Language language;
  const char *word;      ///< the name in statistics and logs
  const char *extension; ///< of a text's file; empty: programs have no text
};
inline constexpr TargetInfo kTargets[kTargetCount] = {
    {GL_FRAGMENT_PROGRAM_ARB, fp::ir::Language::ArbFragment, "fragment", ".fp"},
    {GL_VERTEX_PROGRAM_ARB, fp::ir::Language::ArbVertex, "vertex", ".vp"},
    {GL_TEXT_FRAGMENT_SHADER_ATI, fp::ir::Language::AtiFragment, "ati_fragment", ".atifs"},
    {GL_FRAGMENT_SHADER_ATI, fp::ir::Language::AtiFragment, "ati_fragment_api", ".atifs"},
    {GL_VERTEX_STATE_PROGRAM_NV, fp::ir::Language::ArbVertex, "vertex_state", ".vsp"},
    {GL_REGISTER_COMBINERS_NV, fp::ir::Language::Combiners, "combiners", ".nvrc"},
    {GL_TEXTURE_SHADER_NV, fp::ir::Language::TextureShaders, "texture_shaders", ".nvts"},
    {GL_VERTEX_SHADER_EXT, fp::ir::Language::ArbVertex, "vertex_shader", ""},
};
[[nodiscard]] constexpr const TargetInfo &infoOf(Target target) {
  return kTargets[std::size_t(target)];
}

/// True if the target's programs, and their texts, are made from GL state.
[[nodiscard]] constexpr bool isOfState(Target target) {
  return target == Target::Combiners || target == Target::TextureShaders;
}

/// True if the target's programs shade vertices of draws.
[[nodiscard]] constexpr bool isOfVertices(Target target) {
  return target == Target::Vertex || target == Target::VertexShader;
}

/// True if draws of the target depend on fixed-function state (host_draw/fixed_function.h).
[[nodiscard]] constexpr bool followsFixedFunction(Target target) {
  return target == Target::AtiText || target == Target::AtiApi || isOfState(target);
}

/// True if the program has a text, and so a hash that names it. A shader that commands made has one
/// once something asks for it (program_load.h). Targets without texts never have one.
[[nodiscard]] inline bool hasText(const CompiledProgram &compiled) {
  return compiled.target == Target::AtiApi ? compiled.commands != nullptr
                                           : *infoOf(compiled.target).extension != '\0';
}

/// Returns a text's file name in captures and in replacement folders: "<hash>.fp".
[[nodiscard]] inline std::string textFileName(Target target, const Hash128 &hash) {
  return toHex(hash) + infoOf(target).extension;
}

/// A program target of a context: one row of Context::targets. It holds all that the program API
/// keeps for a target, so that each command is written once.
struct ProgramTarget {
  Target target = Target::Fragment;
  /// The layer implements the target in this context; else the host answers its commands.
  bool offered = false;
  bool enabled = false;
  /// Bits of ContextHot::attention that a change of an env or local parameter sets.
  std::uint32_t parameterBits = 0;
  /// The version of `bound` at the last check.
  std::uint32_t seenVersion = 0;
  std::shared_ptr<ProgramObject> bound; ///< null only in the null context
  std::vector<Vec4> env;
  std::uint32_t envVersion = 0; ///< counts changes of `env`
  /// One bit for each four of `env` that track a matrix (NV_vertex_program 2.14.5). The
  /// application's commands do not change these.
  std::uint64_t tracked = 0;
  fp::Limits limits; ///< answered by GetProgramiv and enforced by the compiler

  [[nodiscard]] const TargetInfo &info() const { return infoOf(target); }
  /// Returns how many local parameters an object has. Named parameters follow the numbered ones.
  [[nodiscard]] std::size_t localsOfObject() const {
    const bool named = target == Target::Fragment && limits.nvOptions != 0;
    return limits.localParameters + (named ? fp::kMaxNamedParameters : 0);
  }
  /// True if env parameter `index` tracks a matrix.
  [[nodiscard]] bool follows(std::size_t index) const {
    return index < 256 && (tracked >> (index / 4) & 1u) != 0;
  }
};

} // namespace arbiter::state
