#pragma once
#include <array>
#include <atomic>
#include <bit>
#include <memory>
#include <string>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/emit.h"
#include "fp_compiler/limits.h"
#include "fp_compiler/native_interface.h"
#include "util/hash.h"

namespace arbiter::fp::ati {
struct Shader;
} // namespace arbiter::fp::ati

namespace arbiter::state {

using Vec4 = std::array<GLfloat, 4>;

/// The program targets (target.h lists the properties of each).
enum class Target : std::uint8_t {
  Fragment,       ///< ARB_fragment_program
  Vertex,         ///< ARB_vertex_program
  AtiText,        ///< ATI_text_fragment_shader
  AtiApi,         ///< ATI_fragment_shader: its objects have their own commands and names
  VertexState,    ///< state programs of NV_vertex_program, which are executed and never bound
  Combiners,      ///< NV_register_combiners: no objects, but state from which programs are made
  TextureShaders, ///< NV_texture_shader: also state; it precedes combiners or texture environments
  VertexShader,   ///< EXT_vertex_shader: its objects have their own commands and names
};
inline constexpr int kTargetCount = 8;
/// When a name becomes a program's: BindProgramARB creates one, NVIDIA's API does so at a load.
enum class Existence : std::uint8_t { Now, OnceLoaded };

class ArrayVariants;
class AtiVariants;
class ClippedVariant;
class DepthVariants;
struct VertexShaderInputs;

/// A compiled program string, with all that queries and draws need. It is immutable, so that
/// contexts of a share group read it without a lock.
struct CompiledProgram : std::enable_shared_from_this<CompiledProgram> {
  Target target = Target::Fragment; ///< the target whose env and local parameters it reads
  std::string text;                 ///< the application's text
  Hash128 hash;                     ///< hash of `text`
  /// The text that was compiled in place of `text` (ARBITER_REPLACE); empty: none.
  std::string replacement;
  std::string warnings; ///< PROGRAM_ERROR_STRING_ARB after the load
  fp::ResourceCounts counts;
  fp::ResourceCounts nativeCounts;
  bool underNativeLimits = false;
  fp::NativeInterface native; ///< for a program in one of NVIDIA's own languages
  fp::GlslShader glsl;
  /// The program of fp::Compilation, from which the host's ARB text and machine code are made. Null
  /// for an ATI shader, but its variants have one, with texture targets, fog and colour sum.
  std::shared_ptr<const fp::ir::Program> program;
  /// Set for an ATI shader, which is emitted for a draw's state only: `glsl` is empty then.
  std::shared_ptr<const AtiVariants> ati;
  /// Set for a shader of ATI_fragment_shader that has a text, and for its variants: the commands
  /// that `text` expresses.
  std::shared_ptr<const fp::ati::Shader> commands;
  /// Set for a vertex program whose `glsl` is not clipped by user clip planes: the variants that
  /// are. Null for these variants themselves.
  std::shared_ptr<const ClippedVariant> clipped;
  /// The variants of a vertex program whose attributes alias, by the arrays that are enabled.
  std::shared_ptr<const ArrayVariants> arrays;
  /// Set for a fragment program, or a variant of an ATI shader: its variants for use with GLSL
  /// 1.30.
  std::shared_ptr<const DepthVariants> depths;
  /// Set for a shader of EXT_vertex_shader, whose `program` is null if it exceeds a limit.
  std::shared_ptr<const VertexShaderInputs> vertexShader;

  [[nodiscard]] bool replaced() const { return !replacement.empty(); }
  /// Returns the text that was compiled.
  [[nodiscard]] const std::string &source() const { return replaced() ? replacement : text; }
};

/// A local parameter. Contexts of a share group may write and read it at the same time without a
/// lock: the specification leaves it to the application which value is seen. Two relaxed halves
/// avoid a data race at the price of plain moves.
class LocalParameter {
public:
  LocalParameter() = default;
  LocalParameter(const LocalParameter &other) { store(other.load()); }
  LocalParameter &operator=(const LocalParameter &other) {
    store(other.load());
    return *this;
  }

  void store(const Vec4 &value) {
    const auto halves = std::bit_cast<std::array<std::uint64_t, 2>>(value);
    m_low.store(halves[0], std::memory_order_relaxed);
    m_high.store(halves[1], std::memory_order_relaxed);
  }
  [[nodiscard]] Vec4 load() const {
    const std::array<std::uint64_t, 2> halves = {m_low.load(std::memory_order_relaxed),
                                                 m_high.load(std::memory_order_relaxed)};
    return std::bit_cast<Vec4>(halves);
  }

private:
  std::atomic<std::uint64_t> m_low{0};
  std::atomic<std::uint64_t> m_high{0};
};

/// A program object of any target (3.11.1). For a target that is the host's, only name and target
/// are used, so that all targets share one name space.
struct ProgramObject {
  ProgramObject(GLuint objectName, Target objectTarget) : name(objectName), target(objectTarget) {}

  const GLuint name;
  const Target target;

  /// Null: no valid program. ProgramString writes it in any context, under the share group's lock.
  /// A draw copies it under the lock, but only after `version` has changed.
  std::shared_ptr<const CompiledProgram> compiled;
  /// The local parameters. They are read and written without a lock, because the specification
  /// leaves the order of unsynchronized changes from two contexts to the application.
  std::vector<LocalParameter> locals;
  /// Counts changes of `compiled` and `locals`, so that other contexts notice them. It is relaxed
  /// and uses no locked instruction, because the application must order changes from two contexts.
  std::atomic<std::uint32_t> version{1};
  /// True if the name is free again; the object lives on only where it is bound.
  std::atomic<bool> deleted{false};
  /// True if the application has a program object of this name, which keeps its target. False if
  /// BindProgramNV bound the name, or a load failed: any target may then be loaded.
  std::atomic<bool> exists{true};

  void changed() {
    version.store(version.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }
  /// Counts a change by a context that had last seen `seen`, and keeps that up to date.
  void changed(std::uint32_t &seen) {
    const std::uint32_t before = version.load(std::memory_order_relaxed);
    version.store(before + 1, std::memory_order_release);
    if (seen == before)
      seen = before + 1;
  }
};

} // namespace arbiter::state
