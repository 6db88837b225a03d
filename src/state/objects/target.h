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

/// What the specifications say of a program target, whatever the context.
struct TargetInfo {
  /// As Enable takes it, and every entry point of the program API (not AtiApi's, Combiners',
  /// TextureShaders' and VertexShader's).
  GLenum name;
  fp::ir::Language language;
  const char *word;      ///< in statistics and logs
  const char *extension; ///< of a text's file name; empty: has no texts
};
inline constexpr TargetInfo kTargets[kTargetCount] = {
    {GL_FRAGMENT_PROGRAM_ARB, fp::ir::Language::ArbFragment, "fragment", ".fp"},
    {GL_VERTEX_PROGRAM_ARB, fp::ir::Language::ArbVertex, "vertex", ".vp"},
    {GL_TEXT_FRAGMENT_SHADER_ATI, fp::ir::Language::AtiFragment, "ati-fragment", ".atifs"},
    {GL_FRAGMENT_SHADER_ATI, fp::ir::Language::AtiFragment, "ati-fragment-api", ".atifs"},
    {GL_VERTEX_STATE_PROGRAM_NV, fp::ir::Language::ArbVertex, "vertex-state", ".vsp"},
    {GL_REGISTER_COMBINERS_NV, fp::ir::Language::Combiners, "combiners", ".nvrc"},
    {GL_TEXTURE_SHADER_NV, fp::ir::Language::TextureShaders, "texture-shaders", ".nvts"},
    {GL_VERTEX_SHADER_EXT, fp::ir::Language::ArbVertex, "vertex-shader", ""},
};
[[nodiscard]] constexpr const TargetInfo &infoOf(Target target) {
  return kTargets[std::size_t(target)];
}

/// The target's programs are made of GL's state, and its texts of that too.
[[nodiscard]] constexpr bool isOfState(Target target) {
  return target == Target::Combiners || target == Target::TextureShaders;
}

/// Its programs shade vertices that are drawn.
[[nodiscard]] constexpr bool isOfVertices(Target target) {
  return target == Target::Vertex || target == Target::VertexShader;
}

/// Draws of the target depend on fixed-function state (host_draw/fixed_function.h).
[[nodiscard]] constexpr bool followsFixedFunction(Target target) {
  return target == Target::AtiText || target == Target::AtiApi || isOfState(target);
}

/// It has a text, and so a name. A shader that commands made has one where something asks for it
/// (program_load.h), others of no target or of all.
[[nodiscard]] inline bool hasText(const CompiledProgram &compiled) {
  return compiled.target == Target::AtiApi ? compiled.commands != nullptr
                                           : *infoOf(compiled.target).extension != '\0';
}

/// The name of a text's file in a capture and in a folder of replacements: "<hash>.fp".
[[nodiscard]] inline std::string textFileName(Target target, const Hash128 &hash) {
  return toHex(hash) + infoOf(target).extension;
}

/// A program target of a context: one row of Context::targets. All that the program API keeps for a
/// target is here, so that each of its commands is written once.
struct ProgramTarget {
  Target target = Target::Fragment;
  /// The target is the layer's in this context; else its commands are the host's to answer.
  bool offered = false;
  bool enabled = false;
  /// Bits of ContextHot::attention that a change of an env or a local parameter sets.
  std::uint32_t parameterBits = 0;
  /// The version of `bound` that was last looked at.
  std::uint32_t seenVersion = 0;
  std::shared_ptr<ProgramObject> bound; ///< never null in a context that is not the null one
  std::vector<Vec4> env;
  std::uint32_t envVersion = 0; ///< counts changes of `env`
  /// Fours of `env` that follow a matrix, one bit each (NV_vertex_program 2.14.5): no command of
  /// the application's changes them.
  std::uint64_t tracked = 0;
  fp::Limits limits; ///< as GetProgramiv answers them and the compiler enforces them

  [[nodiscard]] const TargetInfo &info() const { return infoOf(target); }
  /// How many an object has: those of the limits, and behind them what has only a name.
  [[nodiscard]] std::size_t localsOfObject() const {
    const bool named = target == Target::Fragment && limits.nvOptions != 0;
    return limits.localParameters + (named ? fp::kMostNamedParameters : 0);
  }
  /// Env parameter `index` follows a matrix.
  [[nodiscard]] bool follows(std::size_t index) const {
    return index < 256 && (tracked >> (index / 4) & 1u) != 0;
  }
};

} // namespace arbiter::state
