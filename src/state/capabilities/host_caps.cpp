#include "state/capabilities/host_caps.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <string_view>

#include "host/host_table.h"
#include "state/capabilities/host_faults.h"

namespace arbiter::state {

namespace {

GLint getInteger(const host::HostTable &host, GLenum pname, GLint fallback) {
  GLint value = fallback;
  host.GetIntegerv(pname, &value);
  return value;
}

void splitWords(const char *text, std::vector<std::string> &words) {
  while (*text) {
    const std::size_t length = std::strcspn(text, " ");
    if (length > 0)
      words.emplace_back(text, length);
    text += length + std::strspn(text + length, " ");
  }
}

const char *getString(const host::HostTable &host, GLenum name) {
  const auto *const text = reinterpret_cast<const char *>(host.GetString(name));
  return text ? text : "";
}

void queryExtensions(const host::HostTable &host, HostCaps &caps) {
  GLint profile = 0;
  if (caps.major > 3 || (caps.major == 3 && caps.minor >= 2))
    profile = getInteger(host, GL_CONTEXT_PROFILE_MASK, 0);
  const bool core = (profile & GL_CONTEXT_CORE_PROFILE_BIT) != 0;
  if (caps.major < 3) {
    splitWords(getString(host, GL_EXTENSIONS), caps.extensions);
  } else {
    const GLint count = getInteger(host, GL_NUM_EXTENSIONS, 0);
    for (GLint i = 0; i < count; ++i) {
      const auto *const name =
          reinterpret_cast<const char *>(host.GetStringi(GL_EXTENSIONS, GLuint(i)));
      if (name)
        caps.extensions.emplace_back(name);
    }
  }
  // OpenGL 3.1 has no profiles: fixed function is there if the extension says so.
  caps.compatibility = !caps.embedded && caps.major >= 1 && !core;
  if (caps.major == 3 && caps.minor == 1)
    caps.compatibility = caps.compatibility && caps.has("GL_ARB_compatibility");
  if (caps.compatibility && caps.major == 3 && caps.minor == 0) {
    const GLint flags = getInteger(host, GL_CONTEXT_FLAGS, 0);
    caps.compatibility = (flags & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) == 0;
  }
}

/// Sets what only the names of the host's renderer and vendor tell. llvmpipe (Mesa 22.3.6) draws
/// the same with every anisotropy limit above 1; softpipe obeys the limit.
/// tests/rasterizer_vs_host/anisotropy.py shows both.
void queryRenderer(const host::HostTable &host, HostCaps &caps) {
  const std::string_view name = getString(host, GL_RENDERER);
  const auto names = [&](const char *part) { return name.find(part) != name.npos; };
  const bool llvmpipe = names("llvmpipe");
  caps.limitsAnisotropy = !llvmpipe;
  caps.clampsNanToOne = llvmpipe;
  // Mesa 23.2 fogs as the specification says: a fog coordinate below 0 has no fog (OpenGL 2.1,
  // 3.10). Earlier releases use its absolute value. The same release changed how line ends are cut.
  constexpr int kFogAndLines = 2302;
  const std::string_view version = getString(host, GL_VERSION);
  const int mesa = releaseOf(version, "Mesa");
  caps.faults = faultsOf(version);
  caps.foldsFogCoordinates = mesa > 0 && mesa < kFogAndLines;
  caps.lineEndsAsEdges = llvmpipe && mesa >= kFogAndLines;
  // NVIDIA's driver (580.159) was seen to have negative fog coordinates in GLSL and in
  // ARB_fragment_program, whose fog options are right. Its clip planes clip GLSL, but only
  // position-invariant ones of its own assembly programs. docs/driver/performance_gpu.md has the
  // cost of a draw by either way.
  const bool nvidia = std::string_view(getString(host, GL_VENDOR)).starts_with("NVIDIA");
  caps.negativeFogDistances = nvidia;
  caps.planesClipPrograms = !nvidia;
  caps.ownFragments = nvidia && caps.fragmentProgram;
  caps.onProcessor = llvmpipe || names("softpipe") || names("Software Rasterizer");
}

/// Queries the capabilities that the rasterizer's mirror needs.
void querySoftwareCaps(HostCaps &caps, int gl) {
  const auto since = [&](int version, std::initializer_list<const char *> extensions) {
    return gl >= version || std::any_of(extensions.begin(), extensions.end(),
                                        [&](const char *name) { return caps.has(name); });
  };
  constexpr int kNever = 1000;
  caps.pixelBuffers = since(21, {"GL_ARB_pixel_buffer_object", "GL_EXT_pixel_buffer_object"});
  caps.provokingVertex = since(32, {"GL_ARB_provoking_vertex", "GL_EXT_provoking_vertex"});
  caps.depthClamp = since(32, {"GL_ARB_depth_clamp", "GL_NV_depth_clamp"});
  caps.depthBounds = since(kNever, {"GL_EXT_depth_bounds_test"});
  caps.clampColor = since(30, {"GL_ARB_color_buffer_float"});
  caps.stencilTwoSide = since(kNever, {"GL_EXT_stencil_two_side"});
  caps.indexedBuffers = since(30, {"GL_EXT_draw_buffers2"});
  caps.indexedBlend = since(40, {"GL_ARB_draw_buffers_blend"});
  caps.srgbFramebuffer = since(30, {"GL_ARB_framebuffer_sRGB", "GL_EXT_framebuffer_sRGB"});
  caps.srgbDecode = since(kNever, {"GL_EXT_texture_sRGB_decode"});
  caps.clipControl = since(45, {"GL_ARB_clip_control"});
  caps.occlusionQuery = since(15, {"GL_ARB_occlusion_query"});
  caps.anySamples = since(33, {"GL_ARB_occlusion_query2"});
  caps.anySamplesConservative = since(43, {"GL_ARB_ES3_compatibility"});
  caps.transformFeedback = since(30, {"GL_EXT_transform_feedback"});
  caps.transformFeedback2 = since(40, {"GL_ARB_transform_feedback2"});
  caps.textureSwizzle = since(33, {"GL_ARB_texture_swizzle", "GL_EXT_texture_swizzle"});
  caps.seamlessCube = since(32, {"GL_ARB_seamless_cube_map"});
  caps.seamlessPerTexture = since(kNever, {"GL_AMD_seamless_cubemap_per_texture"});
  caps.fogDistance = since(kNever, {"GL_NV_fog_distance"});
  caps.filterMinmax = since(46, {"GL_ARB_texture_filter_minmax"});
  caps.vertexArrays = since(30, {"GL_ARB_vertex_array_object"});
  caps.instanced = since(33, {"GL_ARB_instanced_arrays"});
  caps.integerArrays = since(30, {"GL_EXT_gpu_shader4"});
  caps.doubleArrays = since(41, {"GL_ARB_vertex_attrib_64bit"});
  caps.primitiveRestart = since(31, {});
  caps.restartNv = since(kNever, {"GL_NV_primitive_restart"});
  caps.fixedIndexRestart = since(43, {"GL_ARB_ES3_compatibility"});
  caps.attribBinding = since(43, {"GL_ARB_vertex_attrib_binding"});
  caps.bufferStorage = since(44, {"GL_ARB_buffer_storage"});
  caps.symmetricSigned = gl >= 42;
  caps.namedSnorm = since(kNever, {"GL_EXT_texture_snorm"});
  caps.copyBuffer = since(31, {"GL_ARB_copy_buffer"});
  caps.syncObjects = since(32, {"GL_ARB_sync"});
}

} // namespace

bool HostCaps::has(const char *extension) const {
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

const char *HostCaps::obstacle() const {
  if (indirect && (major < 2 || glslVersion < 120))
    return "the context is indirect: the X server draws, and takes no GLSL";
  if (!compatibility)
    return "the context has no fixed function (core profile or OpenGL ES)";
  if (major < 2)
    return "the host's GL is older than 2.0";
  if (glslVersion < 120)
    return "the host has no GLSL 1.20";
  return nullptr;
}

HostCaps queryHostCaps(const host::HostTable &host) {
  HostCaps caps;
  const char *const version = getString(host, GL_VERSION);
  caps.embedded = std::strncmp(version, "OpenGL ES", 9) == 0;
  if (!caps.embedded)
    (void)std::sscanf(version, "%d.%d", &caps.major, &caps.minor);
  if (caps.embedded || caps.major == 0)
    return caps;
  queryExtensions(host, caps);
  int glslMajor = 0, glslMinor = 0;
  if (caps.major >= 2 && std::sscanf(getString(host, GL_SHADING_LANGUAGE_VERSION), "%d.%d",
                                     &glslMajor, &glslMinor) == 2)
    caps.glslVersion = glslMajor * 100 + glslMinor;
  const int gl = caps.major * 10 + caps.minor;
  caps.vertexProgram = caps.has("GL_ARB_vertex_program");
  caps.fragmentProgram = caps.has("GL_ARB_fragment_program");
  caps.parameterRuns = caps.has("GL_EXT_gpu_program_parameters");
  caps.textureRectangle = gl >= 31 || caps.has("GL_ARB_texture_rectangle");
  caps.fragCoordConventions = gl >= 32 || caps.has("GL_ARB_fragment_coord_conventions");
  caps.drawBuffers = gl >= 20 || caps.has("GL_ARB_draw_buffers");
  caps.bitEncoding = caps.has("GL_EXT_gpu_shader4") && caps.has("GL_ARB_shader_bit_encoding");
  caps.samplerObjects = gl >= 33 || caps.has("GL_ARB_sampler_objects");
  caps.framebufferObjects =
      gl >= 30 || caps.has("GL_ARB_framebuffer_object") || caps.has("GL_EXT_framebuffer_blit");
  caps.pipelines = gl >= 41 || caps.has("GL_ARB_separate_shader_objects");
  caps.anisotropy = gl >= 46 || caps.has("GL_EXT_texture_filter_anisotropic") ||
                    caps.has("GL_ARB_texture_filter_anisotropic");
  if (caps.anisotropy)
    host.GetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &caps.maxAnisotropy);
  queryRenderer(host, caps);
  caps.shadow = gl >= 14 || caps.has("GL_ARB_shadow");
  querySoftwareCaps(caps, gl);
  if (!caps.compatibility)
    return caps;
  caps.extensionBytes = std::strlen(getString(host, GL_EXTENSIONS));
  caps.maxAttribStackDepth = getInteger(host, GL_MAX_ATTRIB_STACK_DEPTH, 16);
  caps.maxTextureUnits = getInteger(host, GL_MAX_TEXTURE_UNITS, 2);
  caps.maxClipPlanes = getInteger(host, GL_MAX_CLIP_PLANES, 6);
  if (caps.provokingVertex)
    caps.quadsFollowProvokingVertex =
        getInteger(host, GL_QUADS_FOLLOW_PROVOKING_VERTEX_CONVENTION, 1) != 0;
  if (gl >= 20) {
    caps.maxTextureCoords = getInteger(host, GL_MAX_TEXTURE_COORDS, 0);
    caps.maxTextureImageUnits = getInteger(host, GL_MAX_TEXTURE_IMAGE_UNITS, 0);
    caps.maxCombinedImageUnits =
        getInteger(host, GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, caps.maxTextureImageUnits);
    caps.maxVertexAttribs = getInteger(host, GL_MAX_VERTEX_ATTRIBS, 16);
    caps.maxDrawBuffers = getInteger(host, GL_MAX_DRAW_BUFFERS, 1);
    caps.maxFragmentUniformComponents = getInteger(host, GL_MAX_FRAGMENT_UNIFORM_COMPONENTS, 0);
  }
  if (caps.vertexProgram || caps.fragmentProgram) {
    caps.maxProgramMatrices = getInteger(host, GL_MAX_PROGRAM_MATRICES_ARB, 0);
    caps.maxProgramMatrixStackDepth = getInteger(host, GL_MAX_PROGRAM_MATRIX_STACK_DEPTH_ARB, 0);
  }
  return caps;
}

bool HostCaps::drawsNvOptions() const { return bitEncoding && has("GL_ARB_shader_texture_lod"); }

bool HostCaps::drawsTextureShaders() const {
  return (namedSnorm || has("GL_NV_texture_shader")) && has("GL_ARB_texture_float") &&
         has("GL_ARB_texture_rg") && textureRectangle;
}

fp::Limits queryHostLimits(GLenum target, const host::HostTable &host, const HostCaps &caps) {
  const auto get = [&](GLenum pname) {
    GLint value = 0;
    host.GetProgramivARB(target, pname, &value);
    return std::uint32_t(std::max(value, 0));
  };
  fp::Limits limits;
  limits.api.instructions = get(GL_MAX_PROGRAM_INSTRUCTIONS_ARB);
  limits.api.temporaries = get(GL_MAX_PROGRAM_TEMPORARIES_ARB);
  limits.api.parameters = get(GL_MAX_PROGRAM_PARAMETERS_ARB);
  limits.api.attribs = get(GL_MAX_PROGRAM_ATTRIBS_ARB);
  limits.native.instructions = get(GL_MAX_PROGRAM_NATIVE_INSTRUCTIONS_ARB);
  limits.native.temporaries = get(GL_MAX_PROGRAM_NATIVE_TEMPORARIES_ARB);
  limits.native.parameters = get(GL_MAX_PROGRAM_NATIVE_PARAMETERS_ARB);
  limits.native.attribs = get(GL_MAX_PROGRAM_NATIVE_ATTRIBS_ARB);
  if (target == GL_VERTEX_PROGRAM_ARB) {
    limits.api.addressRegisters = get(GL_MAX_PROGRAM_ADDRESS_REGISTERS_ARB);
    limits.native.addressRegisters = get(GL_MAX_PROGRAM_NATIVE_ADDRESS_REGISTERS_ARB);
  } else {
    limits.api.aluInstructions = get(GL_MAX_PROGRAM_ALU_INSTRUCTIONS_ARB);
    limits.api.texInstructions = get(GL_MAX_PROGRAM_TEX_INSTRUCTIONS_ARB);
    limits.api.texIndirections = get(GL_MAX_PROGRAM_TEX_INDIRECTIONS_ARB);
    limits.native.aluInstructions = get(GL_MAX_PROGRAM_NATIVE_ALU_INSTRUCTIONS_ARB);
    limits.native.texInstructions = get(GL_MAX_PROGRAM_NATIVE_TEX_INSTRUCTIONS_ARB);
    limits.native.texIndirections = get(GL_MAX_PROGRAM_NATIVE_TEX_INDIRECTIONS_ARB);
  }
  limits.localParameters = get(GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB);
  limits.envParameters = get(GL_MAX_PROGRAM_ENV_PARAMETERS_ARB);
  limits.textureCoords = std::uint32_t(caps.maxTextureCoords);
  limits.textureImageUnits = std::uint32_t(caps.maxTextureImageUnits);
  limits.textureUnits = std::uint32_t(caps.maxTextureUnits);
  limits.programMatrices = std::uint32_t(caps.maxProgramMatrices);
  limits.programMatrixStackDepth = std::uint32_t(caps.maxProgramMatrixStackDepth);
  limits.drawBuffers = std::uint32_t(caps.maxDrawBuffers);
  limits.vertexAttribs = std::uint32_t(caps.maxVertexAttribs);
  limits.clipPlanes = std::uint32_t(caps.maxClipPlanes);
  return limits;
}

std::vector<std::string> filterExtensions(const HostCaps &caps, bool offered) {
  // The layer refuses text in these languages, so applications must not see the extensions.
  static constexpr const char *kHidden[] = {
      "GL_NV_fragment_program",       "GL_NV_fragment_program_option",
      "GL_NV_fragment_program2",      "GL_NV_fragment_program4",
      "GL_NV_gpu_program4",           "GL_NV_gpu_program4_1",
      "GL_NV_gpu_program5",           "GL_NV_gpu_program5_mem_extended",
      "GL_NV_gpu_program_fp64",       "GL_NV_vertex_program",
      "GL_NV_vertex_program1_1",      "GL_NV_vertex_program2",
      "GL_NV_vertex_program2_option", "GL_NV_vertex_program3",
      "GL_NV_vertex_program4",
  };
  static constexpr const char *kOurs[] = {"GL_ARB_fragment_program", "GL_ARB_vertex_program",
                                          "GL_ATI_fragment_shader", "GL_ATI_text_fragment_shader",
                                          "GL_ARBITER_feedback"};
  std::vector<std::string> names;
  for (const std::string &name : caps.extensions) {
    const bool hidden = offered && std::any_of(std::begin(kHidden), std::end(kHidden),
                                               [&](const char *h) { return name == h; });
    // Without GLSL the layer cannot draw programs on this host, so it must not announce them.
    const bool lie = !offered && caps.compatibility &&
                     (name == "GL_ARB_fragment_program" ||
                      name == "GL_ARB_fragment_program_shadow" || name == "GL_ARB_vertex_program");
    if (!hidden && !lie)
      names.push_back(name);
  }
  if (offered) {
    const auto add = [&](const char *name) {
      if (std::find(names.begin(), names.end(), name) == names.end())
        names.emplace_back(name);
    };
    for (const char *name : kOurs)
      add(name);
    if (caps.shadow)
      add("GL_ARB_fragment_program_shadow");
  }
  return names;
}

} // namespace arbiter::state
