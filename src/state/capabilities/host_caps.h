#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <GL/gl.h>

#include "fp_compiler/limits.h"

namespace arbiter::host {
struct HostTable;
}

namespace arbiter::state {

/// The capabilities of a host context, queried once when it is first current.
struct HostCaps {
  int major = 0;
  int minor = 0;
  int glslVersion = 0; ///< 120, 330 ..; 0 without GLSL
  bool embedded = false;
  bool compatibility = false; ///< has fixed function
  bool indirect = false;      ///< indirect rendering: the X server draws
  bool vertexProgram = false;
  bool fragmentProgram = false;
  bool parameterRuns = false; ///< EXT_gpu_program_parameters: sets several parameters in one call
  bool textureRectangle = false;
  bool fragCoordConventions = false;
  bool drawBuffers = false;
  bool bitEncoding = false; ///< GL_EXT_gpu_shader4 and GL_ARB_shader_bit_encoding
  bool samplerObjects = false;
  bool pipelines = false;
  bool framebufferObjects = false;
  bool shadow = false; ///< TEXTURE_COMPARE_MODE exists
  bool anisotropy = false;
  // These tell which state beyond OpenGL 2.0 can be queried.
  bool pixelBuffers = false;
  bool provokingVertex = false;
  bool quadsFollowProvokingVertex = false; ///< the provoking vertex convention applies to quads
  bool depthClamp = false;
  bool depthBounds = false;
  bool clampColor = false;     ///< CLAMP_FRAGMENT_COLOR and CLAMP_VERTEX_COLOR
  bool stencilTwoSide = false; ///< EXT_stencil_two_side, beside the separate faces of 2.0
  bool indexedBuffers = false; ///< BLEND and COLOR_WRITEMASK per draw buffer
  bool indexedBlend = false;   ///< blend functions per draw buffer
  bool srgbFramebuffer = false;
  bool srgbDecode = false; ///< TEXTURE_SRGB_DECODE_EXT exists
  bool clipControl = false;
  bool occlusionQuery = false;
  bool anySamples = false;
  bool anySamplesConservative = false;
  bool transformFeedback = false;  ///< PRIMITIVES_GENERATED and RASTERIZER_DISCARD
  bool transformFeedback2 = false; ///< TRANSFORM_FEEDBACK_ACTIVE can be queried
  bool textureSwizzle = false;
  bool seamlessCube = false;
  bool seamlessPerTexture = false; ///< AMD_seamless_cubemap_per_texture
  bool fogDistance = false;        ///< NV_fog_distance
  bool filterMinmax = false;
  bool vertexArrays = false; ///< vertex array objects
  bool instanced = false;    ///< vertex attribute divisors
  bool integerArrays = false;
  bool doubleArrays = false;
  bool primitiveRestart = false;
  bool restartNv = false; ///< PRIMITIVE_RESTART_NV, a client state
  bool fixedIndexRestart = false;
  bool attribBinding = false; ///< vertex buffer bindings apart from attribute formats
  bool bufferStorage = false;
  bool namedSnorm = false;      ///< signed luminance, intensity and alpha of EXT_texture_snorm
  bool symmetricSigned = false; ///< signed normalised numbers convert as in OpenGL 4.2
  bool syncObjects = false;     ///< FenceSync (ARB_sync)
  bool copyBuffer = false;      ///< COPY_READ_BUFFER, a binding that draws do not use
  GLfloat maxAnisotropy = 1;    ///< MAX_TEXTURE_MAX_ANISOTROPY
  bool limitsAnisotropy = true; ///< obeys a texture's limit; else any limit above 1 acts as the
                                ///< greatest
  /// Fixed function takes the absolute value of a negative fog coordinate.
  bool foldsFogCoordinates = false;
  bool lineEndsAsEdges = false; ///< see swrast::RasterState
  /// Clamping a vertex colour turns NaN into 1; else into 0.
  bool clampsNanToOne = false;
  bool onProcessor = false; ///< draws in software, more slowly than the rasterizer
  GLint maxAttribStackDepth = 16;
  GLint maxTextureCoords = 0;
  GLint maxTextureImageUnits = 0;
  GLint maxCombinedImageUnits = 0; ///< of all stages together
  GLint maxTextureUnits = 0;
  GLint maxProgramMatrices = 0;
  GLint maxProgramMatrixStackDepth = 0;
  GLint maxDrawBuffers = 1;
  GLint maxVertexAttribs = 16;
  GLint maxClipPlanes = 6;
  GLint maxFragmentUniformComponents = 0;
  /// With FRAGMENT_DEPTH, a fragment shader's fog coordinate is the eye's z, which is negative.
  bool negativeFogDistances = false;
  /// Clip planes clip the clip-space results of its own vertex programs.
  bool planesClipPrograms = true;
  /// Its own ARB fragment programs draw as specified, and cost no more than GLSL unless parameters
  /// change before each draw (host_draw/linking/fragment_assembly.h).
  bool ownFragments = false;
  std::uint32_t faults = 0; ///< bits of HostFault (capabilities/host_faults.h)
  std::vector<std::string> extensions;
  std::size_t extensionBytes = 0; ///< length of the GL_EXTENSIONS string; 0: not known

  [[nodiscard]] bool has(const char *extension) const;

  /// True if the host can draw programs with NVIDIA's options. They need float bits and explicit
  /// levels of detail in fragment shaders, which GLSL 1.20 lacks.
  [[nodiscard]] bool drawsNvOptions() const;
  /// True if host formats can stand in for the texture formats of NV_texture_shader.
  [[nodiscard]] bool drawsTextureShaders() const;
  /// True if a vertex program's clip distances can be drawn: gl_ClipDistance came with GLSL 1.30.
  [[nodiscard]] bool clipDistances() const { return glslVersion >= 130; }

  /// Returns why the layer cannot implement ARB programs here; null if it can.
  [[nodiscard]] const char *obstacle() const;
};

[[nodiscard]] HostCaps queryHostCaps(const host::HostTable &host);

/// Returns the host's own limits of a program target, for the profile `host`.
[[nodiscard]] fp::Limits queryHostLimits(GLenum target, const host::HostTable &host,
                                         const HostCaps &caps);

/// The extensions that an application sees.
struct FilteredExtensions {
  std::vector<std::string> names; ///< for GetStringi
  std::string joined;             ///< for GetString, which may leave some out

  bool operator==(const FilteredExtensions &) const = default;
};
/// Returns the host's extensions plus the layer's. Leaves out those that offer fragment programs in
/// a language that the layer refuses.
[[nodiscard]] std::vector<std::string> filterExtensions(const HostCaps &caps, bool offered);

} // namespace arbiter::state
