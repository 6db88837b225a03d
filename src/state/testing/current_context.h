#pragma once
#include <string>
#include <string_view>

#include "host/handlers.h"
#include "state/context/context.h"
#include "state/host_draw/prepare_draw.h"
#include "state/lifecycle/lifecycle.h"
#include "state/share/share_group.h"
#include "state/testing/fake_host.h"

namespace arbiter::state::testing {

inline constexpr GLenum kFragment = GL_FRAGMENT_PROGRAM_ARB;
inline constexpr GLenum kVertex = GL_VERTEX_PROGRAM_ARB;
inline constexpr char kPlacingText[] = "!!ARBvp1.0\nMOV result.position, vertex.position;\nEND";

/// A context of the fake host, which is current while this lives.
class CurrentContext {
public:
  explicit CurrentContext(FakeHost &host, Context *share = nullptr)
      : m_context(createContext(Provider::Egl, host.table(), share)) {
    makeCurrent(m_context);
  }
  ~CurrentContext() {
    destroyContext(m_context);
    if (currentContext() == m_context)
      makeCurrent(nullptr);
  }
  CurrentContext(const CurrentContext &) = delete;
  CurrentContext &operator=(const CurrentContext &) = delete;
  Context &operator*() const { return *m_context; }
  Context *operator->() const { return m_context; }

private:
  Context *m_context;
};

inline void load(Context &context, std::string_view text, GLenum target = kFragment) {
  handlers::ProgramStringARB(context, target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()),
                             text.data());
}

/// Binds a new object with that text and enables the target.
inline GLuint use(Context &context, std::string_view text, GLenum target = kFragment) {
  GLuint name = 0;
  handlers::GenProgramsARB(context, 1, &name);
  handlers::BindProgramARB(context, target, name);
  load(context, text, target);
  handlers::Enable(context, target);
  return name;
}

/// Does what a draw's entry point does before it calls the host. Returns false if the draw is
/// dropped.
inline bool draw(Context &context) {
  if (context.attention && !prepareDraw(context, GL_TRIANGLES))
    return false;
  ++*context.drawCounter;
  return true;
}

inline std::uint64_t drawsBy(const Context &context, Path path) {
  return context.counters.draws[std::size_t(path)];
}

} // namespace arbiter::state::testing
