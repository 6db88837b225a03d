#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/host_table.h"

namespace arbiter::state::testing {

/// A host GL for unit tests: records the calls that matter, keeps the little state that the tracker
/// asks for, and fails where it is told to. Functions that it does not know do nothing and return
/// 0, as a host's missing ones do.
class FakeHost {
public:
  FakeHost();
  ~FakeHost();
  FakeHost(const FakeHost &) = delete;
  FakeHost &operator=(const FakeHost &) = delete;

  /// Valid until the fake dies; reads the members below when called.
  [[nodiscard]] const host::HostTable *table() const { return &m_table; }

  // --- What it is ---
  std::string version = "3.0 Fake";
  std::string shadingLanguage = "1.30";
  std::vector<std::string> extensions = {"GL_ARB_vertex_program", "GL_ARB_fragment_program",
                                         "GL_NV_fragment_program2"};
  std::map<GLenum, GLint> integers;      ///< further answers of GetIntegerv
  GLint programLimit = 64;               ///< what GetProgramivARB answers
  std::map<GLenum, GLint> programLimits; ///< and of single limits
  std::set<GLenum> enabled;              ///< what IsEnabled says; Enable and Disable leave it
  std::map<GLenum, std::vector<GLfloat>> floats; ///< answers of GetFloatv: matrices, current values

  // --- How it fails ---
  bool compileFails = false;
  bool linkFails = false;
  bool createFails = false;
  bool refusesAssembly = false;
  bool lost = false;          ///< CONTEXT_LOST for ever; queries leave their arguments as they are
  GLenum error = GL_NO_ERROR; ///< pending

  // --- What it holds ---
  GLuint currentProgram = 0;
  std::set<GLuint> programs;
  std::set<GLuint> shaders;
  /// The types of the shaders of a program of the application's.
  std::map<GLuint, std::vector<GLenum>> stages;
  std::set<GLuint> lists;
  GLuint compiling = 0;                           ///< the list between NewList and EndList
  std::map<GLint, std::vector<GLfloat>> uniforms; ///< by location, of whichever program
  GLuint lastName = 0;
  int attribDepth = 0;
  std::map<GLuint, std::string> assembly;           ///< the text of each program object
  std::map<GLenum, GLuint> bound;                   ///< program objects, by target
  std::map<GLenum, bool> targets;                   ///< whether a program target is enabled
  std::vector<std::map<GLenum, bool>> savedTargets; ///< by PushAttrib
  std::set<GLuint> attribArrays;                    ///< generic arrays that are enabled

  /// As one without programs in assembly.
  void offerNoAssembly() { extensions.clear(); }

  /// "UseProgram 3", in order.
  std::vector<std::string> calls;
  [[nodiscard]] int count(const std::string &call) const;
  int queries = 0; ///< of GetIntegerv and IsEnabled
  /// Calls that would be recorded into the application's list, had it been a real host.
  std::vector<std::string> recorded;

  void note(const std::string &call);
  void raise(GLenum e) {
    if (error == GL_NO_ERROR)
      error = e;
  }

  static FakeHost *s_active; ///< the one of the running test

private:
  host::HostTable m_table;
};

} // namespace arbiter::state::testing
