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

/// The program targets (target.h says what is known of each).
enum class Target : std::uint8_t {
  Fragment,       ///< ARB_fragment_program
  Vertex,         ///< ARB_vertex_program
  AtiText,        ///< ATI_text_fragment_shader
  AtiApi,         ///< ATI_fragment_shader: its objects have commands and names of their own
  VertexState,    ///< state programs of NV_vertex_program, which are executed and never bound
  Combiners,      ///< NV_register_combiners: state, not objects, of which programs are made
  TextureShaders, ///< NV_texture_shader: the same, before combiners or texture environments
  VertexShader,   ///< EXT_vertex_shader: its objects have commands and names of their own
};
inline constexpr int kTargetCount = 8;
/// When a name becomes a program's: BindProgramARB makes one, under NVIDIA's API a load does.
enum class Existence : std::uint8_t { Now, OnceLoaded };

class ArrayVariants;
class AtiVariants;
class ClippedVariant;
class DepthVariants;
struct VertexShaderInputs;

/// A program string that loaded: what every query and every draw needs of it. Immutable, so that
/// contexts of a share group read it without a lock.
struct CompiledProgram : std::enable_shared_from_this<CompiledProgram> {
  Target target = Target::Fragment; ///< whose env and local parameters it reads
  std::string text;                 ///< the application's
  Hash128 hash;                     ///< of `text`
  /// What was compiled in place of `text` (ARBITER_REPLACE); empty: nothing was.
  std::string replacement;
  std::string warnings; ///< PROGRAM_ERROR_STRING_ARB after the load
  fp::ResourceCounts counts;
  fp::ResourceCounts nativeCounts;
  bool underNativeLimits = false;
  fp::NativeInterface native; ///< of a program in one of NVIDIA's languages of their own
  fp::GlslShader glsl;
  /// As fp::Compilation has it: what the host's ARB path is given, and machine code is made of.
  /// Null of an ATI shader; the forms that draws are made with have it, with targets, fog and
  /// colour sum.
  std::shared_ptr<const fp::ir::Program> program;
  /// Of an ATI shader, which is emitted for a draw's state and not before: `glsl` is empty then.
  std::shared_ptr<const AtiVariants> ati;
  /// Of a shader of ATI_fragment_shader that has a text, and of its forms: what its commands said,
  /// which `text` says too.
  std::shared_ptr<const fp::ati::Shader> commands;
  /// Of a vertex program, whose `glsl` user clip planes do not clip: the form that they do. Null of
  /// that form itself.
  std::shared_ptr<const ClippedVariant> clipped;
  /// The variants of a vertex program whose attributes alias, by the arrays that it is drawn with.
  std::shared_ptr<const ArrayVariants> arrays;
  /// Of a fragment program, or a form of an ATI shader: its forms beside GLSL 1.30.
  std::shared_ptr<const DepthVariants> depths;
  /// Of a shader of EXT_vertex_shader, whose `program` is null where it is over a limit.
  std::shared_ptr<const VertexShaderInputs> vertexShader;

  [[nodiscard]] bool replaced() const { return !replacement.empty(); }
  /// The text that was compiled.
  [[nodiscard]] const std::string &source() const { return replaced() ? replacement : text; }
};

/// A local parameter. Contexts of a share group may write and read it at once, without a lock: the
/// specification leaves to the application which of the values is seen. Two relaxed halves make
/// that no data race, at the price of plain moves.
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

/// A program object of any target (3.11.1). Of a target that is the host's only name and target are
/// here, so that all targets share one name space.
struct ProgramObject {
  ProgramObject(GLuint objectName, Target objectTarget) : name(objectName), target(objectTarget) {}

  const GLuint name;
  const Target target;

  /// Null: no valid program. Written by ProgramString in any context, under the share group's lock;
  /// a draw copies it, under the lock, only after `version` has moved.
  std::shared_ptr<const CompiledProgram> compiled;
  /// Local parameters; read and written without a lock, as the specification leaves the order of
  /// unsynchronised changes from two contexts to the application.
  std::vector<LocalParameter> locals;
  /// Counts changes of `compiled` and `locals`: how another context sees one. Relaxed and without a
  /// locked instruction, because changes from two contexts are the application's to order.
  std::atomic<std::uint32_t> version{1};
  /// Its name is free again: it lives on only where it is bound.
  std::atomic<bool> deleted{false};
  /// It is a program object to the application, and keeps its target. Else its name was bound by
  /// BindProgramNV, or a load failed, and any target may be loaded for it.
  std::atomic<bool> exists{true};

  void changed() {
    version.store(version.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }
  /// The same, by a context that had last looked at `seen`: it has seen its own change.
  void changed(std::uint32_t &seen) {
    const std::uint32_t before = version.load(std::memory_order_relaxed);
    version.store(before + 1, std::memory_order_release);
    if (seen == before)
      seen = before + 1;
  }
};

} // namespace arbiter::state
