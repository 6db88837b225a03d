#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <GL/gl.h>

#include "state/host_draw/change_pace.h"
#include "state/objects/program_object.h"

namespace arbiter::state {

class Context;
struct AssemblyProgram;
struct LinkedProgram;
struct ProgramPair;

/// The host's target of the program's language.
[[nodiscard]] GLenum hostAssemblyTarget(const CompiledProgram &compiled);

/// What is bound and enabled of the host's own ARB path. Vertex programs are the host's there where
/// they can be (LinkedProgram says why). Fragment programs are where the application's GLSL program
/// has the vertex stage alone, as no GLSL program of the layer's can join one of the application's,
/// where a program is so long that the host's GLSL compiler may not survive it, and where
/// fragment_assembly.h says.
class HostAssembly {
public:
  /// Binds and enables the programs of `pair` on the host, loading each at its first call; a stage
  /// that has none is disabled. False, with nothing enabled, if the host refuses one. Raises no
  /// error.
  [[nodiscard]] bool apply(Context &context, const ProgramPair &pair);
  /// The stages of `linkedProgram` that are assembly; nothing else stays enabled.
  void apply(Context &context, const LinkedProgram &linkedProgram);
  /// Gives the host the env and local values that the enabled programs read, as far as they
  /// changed, of the stages that `attention` names.
  void uploadParameters(Context &context, std::uint32_t attention);
  /// After a choice, and what it needs has been sent: local parameters of this vertex program may
  /// go to the host as they are given. Null: none may.
  void sendDirectly(AssemblyProgram *vertices) { m_direct = vertices; }
  /// A local parameter of the vertex program that is bound, in a context where nothing waits for a
  /// draw. True: the host has it, and nothing waits. That is so of the first one after a draw:
  /// where draws have more of them, one call for them all is better.
  [[nodiscard]] bool sendLocal(Context &context, GLuint index, const Vec4 &value);
  /// Enables the host's fragment target with no program in it: each draw is the host's error then,
  /// as it would be the layer's. False if the host has no such target.
  [[nodiscard]] bool refuse(Context &context);
  [[nodiscard]] bool refuses() const { return m_refuses; }
  /// PopAttrib may have brought back an enable of the layer's on the host, or taken one away.
  void restoreEnables(Context &context) const;
  /// The same of CopyContext, whose target need not be current: at the next choice of programs.
  void enablesCopied() { m_used = m_copied = true; }
  /// Disables what apply() enabled.
  void release(Context &context);
  /// The program is about to be deleted.
  void forget(Context &context, const AssemblyProgram *program);
  /// Another program was bound to the host's `target` (GL_VERTEX_PROGRAM_ARB or
  /// GL_FRAGMENT_PROGRAM_ARB): binds again the one that is enabled there, if one is.
  void bindAgain(Context &context, GLenum target) const;
  /// One of the host's targets is enabled by the layer.
  [[nodiscard]] bool active() const { return m_active[0] || m_active[1] || m_refuses; }
  /// The host draws with this program now, as assembly rather than as GLSL.
  [[nodiscard]] bool runs(const CompiledProgram *compiled) const;

private:
  void applyStages(Context &context, const std::array<AssemblyProgram *, 2> &programs);
  void applyStage(Context &context, std::size_t stage, AssemblyProgram *program);
  void uploadStage(Context &context, std::size_t stage);

  bool m_refuses = false;
  bool m_used = false;   ///< the host's enables were ever set
  bool m_copied = false; ///< they may be others than m_active says
  /// Vertex, fragment; null where the host's target is disabled.
  std::array<AssemblyProgram *, 2> m_active = {};
  std::array<GLuint, 2> m_bound = {};     ///< on the host
  std::array<std::vector<Vec4>, 2> m_env; ///< the host's env values, as far as they were set
  ChangePace m_fragmentPace;
  AssemblyProgram *m_direct = nullptr; ///< sendDirectly()
  std::uint64_t m_directAt = ~0ull;    ///< Context::drawCounter when one was sent so
};

} // namespace arbiter::state
