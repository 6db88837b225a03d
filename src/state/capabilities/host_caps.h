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

/// What the host's context can do, asked once when it is first current.
struct HostCaps {
  int major = 0;
  int minor = 0;
  int glslVersion = 0; ///< 120, 330; 0 if there is none
  bool embedded = false;
  bool compatibility = false; ///< fixed function is there
  bool indirect = false;      ///< the X server draws what the host is told
  bool vertexProgram = false;
  bool fragmentProgram = false;
  bool parameterRuns = false; ///< EXT_gpu_program_parameters: several parameters in one call
  bool textureRectangle = false;
  bool fragCoordConventions = false;
  bool drawBuffers = false;
  bool bitEncoding = false; ///< GL_EXT_gpu_shader4 and GL_ARB_shader_bit_encoding
  bool samplerObjects = false;
  bool pipelines = false;
  bool framebufferObjects = false;
  bool shadow = false; ///< TEXTURE_COMPARE_MODE exists
  bool anisotropy = false;
  // What of the state beyond OpenGL 2.0 can be asked for.
  bool pixelBuffers = false;
  bool provokingVertex = false;
  bool quadsFollowProvokingVertex = false; ///< the convention is theirs too
  bool depthClamp = false;
  bool depthBounds = false;
  bool clampColor = false;     ///< CLAMP_FRAGMENT_COLOR and CLAMP_VERTEX_COLOR
  bool stencilTwoSide = false; ///< EXT_stencil_two_side, beside 2.0's separate faces
  bool indexedBuffers = false; ///< BLEND and COLOR_WRITEMASK of each draw buffer
  bool indexedBlend = false;   ///< blend functions of each draw buffer
  bool srgbFramebuffer = false;
  bool srgbDecode = false; ///< TEXTURE_SRGB_DECODE_EXT exists
  bool clipControl = false;
  bool occlusionQuery = false;
  bool anySamples = false;
  bool anySamplesConservative = false;
  bool transformFeedback = false;  ///< PRIMITIVES_GENERATED and RASTERIZER_DISCARD
  bool transformFeedback2 = false; ///< whether it is active can be asked for
  bool textureSwizzle = false;
  bool seamlessCube = false;
  bool seamlessPerTexture = false; ///< AMD_seamless_cubemap_per_texture
  bool fogDistance = false;        ///< NV_fog_distance
  bool filterMinmax = false;
  bool vertexArrays = false; ///< vertex array objects
  bool instanced = false;    ///< divisors of arrays
  bool integerArrays = false;
  bool doubleArrays = false;
  bool primitiveRestart = false;
  bool restartNv = false; ///< PRIMITIVE_RESTART_NV, a client state
  bool fixedIndexRestart = false;
  bool attribBinding = false; ///< buffers bound apart from the pointers
  bool bufferStorage = false;
  bool symmetricSigned = false; ///< signed normalised numbers as from 4.2 on
  bool syncObjects = false;     ///< FenceSync (ARB_sync)
  bool copyBuffer = false;      ///< COPY_READ_BUFFER, which may be bound without a trace
  GLfloat maxAnisotropy = 1;    ///< MAX_TEXTURE_MAX_ANISOTROPY
  bool limitsAnisotropy = true; ///< by a texture's own limit; else any above 1 is the greatest
  /// Of a fog coordinate below 0 it takes the absolute value in fixed function.
  bool foldsFogCoordinates = false;
  bool lineEndsAsEdges = false; ///< swrast::RasterState
  /// What is no number counts as 1 where it clamps the colours of vertices; else as 0.
  bool clampsNanToOne = false;
  bool onProcessor = false; ///< it draws there, where the rasterizer is the faster one
  GLint maxAttribStackDepth = 16;
  GLint maxTextureCoords = 0;
  GLint maxTextureImageUnits = 0;
  GLint maxCombinedImageUnits = 0; ///< of all stages
  GLint maxTextureUnits = 0;
  GLint maxProgramMatrices = 0;
  GLint maxProgramMatrixStackDepth = 0;
  GLint maxDrawBuffers = 1;
  GLint maxVertexAttribs = 16;
  GLint maxClipPlanes = 6;
  GLint maxFragmentUniformComponents = 0;
  /// A fragment shader's fog coordinate by FRAGMENT_DEPTH is z to the eye, which is below 0.
  bool negativeFogDistances = false;
  /// Planes clip what its own vertex programs give, in clip space.
  bool planesClipPrograms = true;
  /// Its own fragment programs draw as the specifications say, and cost it no more than GLSL but
  /// where parameters change before each draw (host_draw/linking/fragment_assembly.h).
  bool ownFragments = false;
  std::uint32_t faults = 0; ///< bits of HostFault (capabilities/host_faults.h)
  std::vector<std::string> extensions;
  std::size_t extensionBytes = 0; ///< of GL_EXTENSIONS as one string; 0: not known

  [[nodiscard]] bool has(const char *extension) const;

  /// Whether programs under NVIDIA's options can be drawn: GLSL 1.20 lacks the bits of floats, and
  /// levels of detail that a fragment program gives.
  [[nodiscard]] bool drawsNvOptions() const;
  /// Whether the texture formats of NV_texture_shader have one of the host's that stands for them.
  [[nodiscard]] bool drawsTextureShaders() const;
  /// Whether a vertex program's clip distances can be drawn: gl_ClipDistance came with GLSL 1.30.
  [[nodiscard]] bool clipDistances() const { return glslVersion >= 130; }

  /// Why the layer cannot implement ARB programs here; null if it can.
  [[nodiscard]] const char *obstacle() const;
};

[[nodiscard]] HostCaps queryHostCaps(const host::HostTable &host);

/// The host's own limits of a program target, for the profile `host`.
[[nodiscard]] fp::Limits queryHostLimits(GLenum target, const host::HostTable &host,
                                         const HostCaps &caps);

/// The extensions that the application sees.
struct FilteredExtensions {
  std::vector<std::string> names; ///< one by one (GetStringi)
  std::string joined;             ///< as one string (GetString), which may have fewer

  bool operator==(const FilteredExtensions &) const = default;
};
/// The host's list, plus what the layer implements, less the extensions that offer fragment program
/// text in a language that the layer refuses.
[[nodiscard]] std::vector<std::string> filterExtensions(const HostCaps &caps, bool offered);

} // namespace arbiter::state
