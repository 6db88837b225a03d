// Contexts: share groups, several on a thread, threads in turn, destruction, copies.
#include <thread>

#include "harness.h"

namespace paths {

namespace {

void severalInTurn(Recorder &r) {
  usePrograms();
  tint(1, 0, 0);
  const GLXContext shared = createContext(mainContext());
  const GLXContext alone = createContext();
  for (int round = 0; round < 3; ++round) {
    makeCurrent(shared);
    if (round == 0) {
      glViewport(0, 0, kSize, kSize);
      usePrograms();
      tint(0, 1, 0);
    }
    gradient(-1, -1, 0, 0);
    makeCurrent(alone);
    if (round == 0) {
      glViewport(0, 0, kSize, kSize);
      r.value("enabled alone", glIsEnabled(kFragment));
      usePrograms();
      tint(0, 0, 1);
    }
    gradient(0, 0, 1, 1);
    makeCurrent(mainContext());
    gradient(-1, 0, 0, 1);
    glProgramEnvParameter4fARB(kVertex, 0, 0.1f, 0, 0, 0);
  }
  r.picture("three contexts");
  makeCurrent(nullptr);
  makeCurrent(mainContext());
  destroyContext(shared);
  destroyContext(alone);
  gradient(0, -1, 0.8f, 0);
  r.picture("after the others");
}

/// Tests that objects of a group outlive the context that made them.
void authorDestroyed(Recorder &r) {
  const GLXContext author = createContext(mainContext());
  makeCurrent(author);
  glViewport(0, 0, kSize, kSize);
  const Programs programs = usePrograms();
  tint(0.5f, 1, 0);
  gradient(-1, -1, 0, 1);
  glFinish();
  makeCurrent(mainContext());
  destroyContext(author);
  glBindProgramARB(kVertex, programs.vertex);
  glBindProgramARB(kFragment, programs.fragment);
  glEnable(kVertex);
  glEnable(kFragment);
  gradient(0, -1, 1, 1);
  r.picture("drawn with what is left");
  for (GLuint name = 1; name < 30; ++name)
    r.value("is program", glIsProgram(name));
}

void destroyedWhileCurrent(Recorder &r) {
  const GLXContext other = createContext(mainContext());
  makeCurrent(other);
  glViewport(0, 0, kSize, kSize);
  usePrograms();
  destroyContext(other);
  tint(1, 1, 0);
  gradient();
  load(kGreen);
  gradient(-0.2f, -0.2f, 0.2f, 0.2f);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  load(kRed);
  gradient(0.2f, 0.2f, 0.4f, 0.4f);
  glEndList();
  glCallList(list);
  r.errors("destroyed, and current");
  r.picture("destroyed, and current");
  makeCurrent(mainContext());
}

/// Tests that another context sees edits when it binds the object again (AFP 3953-3974).
void editedElsewhere(Recorder &r) {
  const Programs programs = usePrograms();
  gradient(-1, -1, 0, 0);
  const GLXContext other = createContext(mainContext());
  makeCurrent(other);
  glViewport(0, 0, kSize, kSize);
  glBindProgramARB(kVertex, programs.vertex);
  load("!!ARBvp1.0\nMOV result.position, vertex.position;\nMOV result.color, program.local[5];\n"
       "END",
       kVertex);
  glProgramLocalParameter4fARB(kVertex, 5, 0, 1, 1, 1);
  glBindProgramARB(kFragment, programs.fragment);
  tint(1, 1, 0.5f);
  glFinish();
  makeCurrent(mainContext());
  glBindProgramARB(kVertex, programs.vertex);
  glBindProgramARB(kFragment, programs.fragment);
  gradient(0, 0, 1, 1);
  r.picture("after the edit");
  makeCurrent(other);
  const GLuint names[] = {programs.vertex, programs.fragment};
  glDeleteProgramsARB(2, names);
  glFinish();
  makeCurrent(mainContext());
  gradient(-1, 0, 0, 1); // as before: they live while they are bound here
  r.errors("deleted elsewhere");
  r.pixel("deleted elsewhere", 24, 40, {0, 255, 128, 255});
  r.check(glIsProgramARB(programs.vertex) == 0, "the name is gone");
  r.picture("deleted elsewhere");
  destroyContext(other);
}

/// Tests one context that is current on one thread after the other.
void threadsInTurn(Recorder &r) {
  usePrograms();
  makeCurrent(nullptr);
  for (int i = 0; i < 4; ++i)
    std::thread([&] {
      makeCurrent(mainContext());
      tint(float(i) / 3, 1, float(i % 2));
      glProgramEnvParameter4fARB(kVertex, 0, float(i) / 2, 0, 0, 0);
      gradient(-1, -1, -0.6f, 1);
      if (i % 2 == 0)
        load(kTintFragments);
      makeCurrent(nullptr);
    }).join();
  makeCurrent(mainContext());
  r.picture("four threads");
}

/// Tests that glXCopyContext copies the enables in GL_ENABLE_BIT, but neither bindings nor
/// parameters.
void copied(Recorder &r) {
  usePrograms();
  XSetErrorHandler([](Display *, XErrorEvent *) { return 0; });
  for (const unsigned long mask : {(unsigned long)GL_ENABLE_BIT, (unsigned long)GL_ALL_ATTRIB_BITS,
                                   (unsigned long)GL_CURRENT_BIT}) {
    const GLXContext other = createContext();
    makeCurrent(other);
    glViewport(0, 0, kSize, kSize);
    makeCurrent(nullptr);
    glXCopyContext(display(), mainContext(), other, mask);
    XSync(display(), False);
    makeCurrent(other);
    const bool wanted = (mask & GL_ENABLE_BIT) != 0;
    r.check(bool(glIsEnabled(kFragment)) == wanted, "the fragment target's enable");
    r.check(bool(glIsEnabled(kVertex)) == wanted, "the vertex target's enable");
    r.check(programiv(GL_PROGRAM_BINDING_ARB) == 0, "the binding is in no group");
    gradient(-1, -1, 0, 0);
    r.check((glGetError() == GL_INVALID_OPERATION) == wanted, "no program is bound");
    makeCurrent(mainContext());
    destroyContext(other);
  }
  glClear(GL_COLOR_BUFFER_BIT);
  gradient();
  r.picture("the source draws on");
}

void resetStatus(Recorder &r) {
  if (!epoxy_has_gl_extension("GL_ARB_robustness"))
    return r.skip("GL_ARB_robustness is not offered here");
  usePrograms();
  gradient();
  r.value("reset status", glGetGraphicsResetStatusARB());
  r.value("strategy", integer(GL_RESET_NOTIFICATION_STRATEGY_ARB));
  GLubyte pixel[4] = {};
  glReadnPixelsARB(32, 32, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, sizeof pixel, pixel);
  r.value("red", pixel[0]);
}

} // namespace

const std::vector<Case> kSharedCases = {
    {"contexts-in-turn", severalInTurn},
    {"contexts-author-destroyed", authorDestroyed},
    {"contexts-destroyed-while-current", destroyedWhileCurrent},
    {"contexts-edited-elsewhere", editedElsewhere,
     "crashes at the draw of a program that another context deleted"},
    {"contexts-threads-in-turn", threadsInTurn},
    {"contexts-copied", copied, "cannot copy a context that renders directly"},
    {"contexts-reset-status", resetStatus},
};

} // namespace paths
