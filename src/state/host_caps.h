#pragma once
#include <memory>
#include <string>
#include <vector>

#include <GL/gl.h>

#include "fp_compiler/limits.h"

namespace arbiter::host {
struct HostTable;
}

namespace arbiter::state {

/// What the host's context can do, asked once when it is first current.
struct HostCaps {
  int major = 0;
  int minor = 0;
  int glslVersion = 0; ///< 120, 330; 0 if there is none
  bool embedded = false;
  bool compatibility = false; ///< fixed function is there
  bool vertexProgram = false;
  bool fragmentProgram = false;
  bool textureRectangle = false;
  bool fragCoordConventions = false;
  bool drawBuffers = false;
  bool bitEncoding = false; ///< GL_EXT_gpu_shader4 and GL_ARB_shader_bit_encoding
  bool samplerObjects = false;
  bool pipelines = false;
  bool framebufferObjects = false;
  bool shadow = false; ///< TEXTURE_COMPARE_MODE exists
  bool anisotropy = false;
  GLint maxAttribStackDepth = 16;
  GLint maxTextureCoords = 0;
  GLint maxTextureImageUnits = 0;
  GLint maxTextureUnits = 0;
  GLint maxProgramMatrices = 0;
  GLint maxProgramMatrixStackDepth = 0;
  GLint maxDrawBuffers = 1;
  GLint maxVertexAttribs = 16;
  GLint maxClipPlanes = 6;
  GLint maxFragmentUniformComponents = 0;
  std::vector<std::string> extensions;

  [[nodiscard]] bool has(const char *extension) const;

  /// Why ARB programs cannot be ours here; null if they can.
  [[nodiscard]] const char *obstacle() const;
};

[[nodiscard]] HostCaps queryHostCaps(const host::HostTable &host);

/// The host's own limits of a program target, for the profile `host`.
[[nodiscard]] fp::Limits queryHostLimits(GLenum target, const host::HostTable &host,
                                         const HostCaps &caps);

/// The extension list that the application sees.
struct FilteredExtensions {
  std::vector<std::string> names;
  std::string joined;

  bool operator==(const FilteredExtensions &) const = default;
};
/// The host's list, plus what the layer implements, less the extensions that offer fragment program
/// text in a language that the layer refuses.
[[nodiscard]] FilteredExtensions filterExtensions(const HostCaps &caps, bool offered);

} // namespace arbiter::state
