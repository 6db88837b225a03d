#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <GL/gl.h>

#include "state/host_draw/change_pace.h"
#include "state/objects/program_object.h"

namespace arbiter::state {

struct DrawContext;
struct AssemblyProgram;
struct LinkedProgram;
struct ProgramPair;

/// Returns the host's target for the program's language.
[[nodiscard]] GLenum hostAssemblyTarget(const CompiledProgram &compiled);

/// The host's own ARB programs that are bound and enabled.
///
/// Vertex programs are assembly where they can be (LinkedProgram says why). Fragment programs are
/// in three cases. The application's GLSL program has the vertex stage alone, which no GLSL of the
/// layer's can join. The program is so long that the host's GLSL compiler may crash. Or
/// fragment_assembly.h chooses it.
class HostAssembly {
public:
  /// Binds and enables the programs of `pair` on the host, and loads each at its first use. A stage
  /// without a program is disabled. Returns false, with nothing enabled, if the host refuses one.
  /// Raises no error.
  [[nodiscard]] bool apply(DrawContext &context, const ProgramPair &pair);
  /// Enables the stages of `linkedProgram` that are assembly, and disables others.
  void apply(DrawContext &context, const LinkedProgram &linkedProgram);
  /// Sends the env and local parameters that the enabled programs read and that have changed. Only
  /// stages in `attention` are considered.
  void uploadParameters(DrawContext &context, std::uint32_t attention);
  /// Allows local parameters of this vertex program to be sent at once when they are set; null: of
  /// none. Call it after a choice, when everything else has been sent.
  void sendDirectly(AssemblyProgram *vertices) { m_direct = vertices; }
  /// Sends a local parameter of the bound vertex program at once. Returns true if nothing then
  /// waits for the draw. This is only done for the first parameter after a draw: for more of them,
  /// one call for all is better. Requires that nothing else waits for a draw.
  [[nodiscard]] bool sendLocal(DrawContext &context, GLuint index, const Vec4 &value);
  /// Enables the host's fragment target without a program, so that each draw is an error. Returns
  /// false if the host has no such target.
  [[nodiscard]] bool refuse(DrawContext &context);
  [[nodiscard]] bool refuses() const { return m_refuses; }
  /// Restores the enables on the host after PopAttrib, which may have changed them.
  void restoreEnables(DrawContext &context) const;
  /// Notes that CopyContext may have changed the enables. The context need not be current, so they
  /// are restored at the next choice of programs.
  void enablesCopied() { m_used = m_copied = true; }
  /// Disables what apply() enabled.
  void release(DrawContext &context);
  /// Unbinds a program that is about to be deleted.
  void forget(DrawContext &context, const AssemblyProgram *program);
  /// Binds the layer's program again after another one was bound to the host's `target`
  /// (GL_VERTEX_PROGRAM_ARB or GL_FRAGMENT_PROGRAM_ARB).
  void bindAgain(DrawContext &context, GLenum target) const;
  /// True if the layer has enabled one of the host's targets.
  [[nodiscard]] bool active() const { return m_active[0] || m_active[1] || m_refuses; }
  /// True if the host draws with this program now, as assembly and not as GLSL.
  [[nodiscard]] bool runs(const CompiledProgram *compiled) const;

private:
  void applyStages(DrawContext &context, const std::array<AssemblyProgram *, 2> &programs);
  void applyStage(DrawContext &context, std::size_t stage, AssemblyProgram *program);
  void uploadStage(DrawContext &context, std::size_t stage);

  bool m_refuses = false;
  bool m_used = false;   ///< true once the layer has enabled a target
  bool m_copied = false; ///< true if the host's enables may differ from m_active
  /// The vertex and the fragment program; null if the target is disabled.
  std::array<AssemblyProgram *, 2> m_active = {};
  std::array<GLuint, 2> m_bound = {};     ///< names bound on the host
  std::array<std::vector<Vec4>, 2> m_env; ///< the host's env values that were set
  ChangePace m_fragmentPace;
  AssemblyProgram *m_direct = nullptr; ///< set by sendDirectly()
  std::uint64_t m_directAt = ~0ull; ///< ContextHot::drawCounter when a parameter was sent at once
};

} // namespace arbiter::state
