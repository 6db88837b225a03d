#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/host_table.h"

namespace arbiter::state::testing {

/// A host GL for unit tests. It records the calls that matter, keeps the little state that the
/// layer queries, and fails where told to. Unknown functions do nothing and return 0, like those
/// that a host lacks.
class FakeHost {
public:
  FakeHost();
  ~FakeHost();
  FakeHost(const FakeHost &) = delete;
  FakeHost &operator=(const FakeHost &) = delete;

  /// Returns the host's table, valid while this lives. Its functions read the members below.
  [[nodiscard]] const host::HostTable *table() const { return &m_table; }

  // --- What it supports ---
  std::string version = "3.0 Fake";
  std::string shadingLanguage = "1.30";
  std::vector<std::string> extensions = {"GL_ARB_vertex_program", "GL_ARB_fragment_program",
                                         "GL_NV_fragment_program2"};
  std::map<GLenum, GLint> integers;      ///< further answers of GetIntegerv
  GLint programLimit = 64;               ///< answer of GetProgramivARB
  std::map<GLenum, GLint> programLimits; ///< answers for single limits
  std::set<GLenum> enabled;              ///< answers of IsEnabled; Enable and Disable do not change
                                         ///< it
  std::map<GLenum, std::vector<GLfloat>> floats; ///< answers of GetFloatv: matrices, current values

  // --- How it fails ---
  bool compileFails = false;
  bool linkFails = false;
  bool createFails = false;
  bool refusesAssembly = false;
  bool lost = false;          ///< CONTEXT_LOST for ever; queries leave their arguments unchanged
  GLenum error = GL_NO_ERROR; ///< pending

  // --- What it holds ---
  GLuint currentProgram = 0;
  std::set<GLuint> programs;
  std::set<GLuint> shaders;
  /// The shader types of an application's program.
  std::map<GLuint, std::vector<GLenum>> stages;
  std::set<GLuint> lists;
  GLuint compiling = 0;                           ///< the list between NewList and EndList
  std::map<GLint, std::vector<GLfloat>> uniforms; ///< by location, of any program
  GLuint lastName = 0;
  int attribDepth = 0;
  std::map<GLuint, std::string> assembly;           ///< text of each program object
  std::map<GLenum, GLuint> bound;                   ///< program objects, by target
  std::map<GLenum, bool> targets;                   ///< enables of program targets
  std::vector<std::map<GLenum, bool>> savedTargets; ///< pushed by PushAttrib
  std::set<GLuint> attribArrays;                    ///< enabled generic arrays

  /// Makes it a host without assembly programs.
  void offerNoAssembly() { extensions.clear(); }

  /// Recorded calls such as "UseProgram 3", in order.
  std::vector<std::string> calls;
  [[nodiscard]] int count(const std::string &call) const;
  int queries = 0; ///< calls of GetIntegerv and IsEnabled
  /// Calls that a real host would have recorded into the application's list.
  std::vector<std::string> recorded;

  void note(const std::string &call);
  void raise(GLenum e) {
    if (error == GL_NO_ERROR)
      error = e;
  }

  static FakeHost *s_active; ///< the host of the running test

private:
  host::HostTable m_table;
};

} // namespace arbiter::state::testing
