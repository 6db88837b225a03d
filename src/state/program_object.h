#pragma once
#include <array>
#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/compiler.h"
#include "util/hash.h"

namespace arbiter::state {

using Vec4 = std::array<GLfloat, 4>;

/// A program string that loaded: what every query and every draw needs of it. Immutable, so that
/// contexts of a share group read it without a lock.
struct CompiledProgram {
  std::string text;
  Hash128 hash;
  std::string warnings; ///< PROGRAM_ERROR_STRING_ARB after the load
  fp::ResourceCounts counts;
  fp::ResourceCounts nativeCounts;
  bool underNativeLimits = false;
  fp::GlslShader glsl;
};

/// A program object of either target (3.11.1). Fragment programs live here alone; of vertex
/// programs only the name and target do, so that the two targets share one name space (the host has
/// the rest).
struct ProgramObject {
  ProgramObject(GLuint objectName, GLenum objectTarget) : name(objectName), target(objectTarget) {}

  const GLuint name;
  const GLenum target; ///< GL_FRAGMENT_PROGRAM_ARB, or GL_VERTEX_PROGRAM_ARB

  /// Null: no valid program. Written by ProgramString in any context, under the share group's lock;
  /// a draw copies it, under the lock, only after `version` has moved.
  std::shared_ptr<const CompiledProgram> compiled;
  /// Local parameters; read and written without a lock, as the specification leaves the order of
  /// unsynchronised changes from two contexts to the application.
  std::vector<Vec4> locals;
  /// Counts changes of `compiled` and `locals`: how another context sees one.
  std::atomic<std::uint32_t> version{1};
};

} // namespace arbiter::state
