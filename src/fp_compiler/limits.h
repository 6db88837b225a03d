#pragma once
#include <cstdint>

namespace arbiter::fp {

/// The resources that are counted for a program, in the order of every report.
/// GL_PROGRAM_<NAME>_ARB and GL_PROGRAM_NATIVE_<NAME>_ARB of ARB_fragment_program query them.
struct ResourceCounts {
  std::uint32_t instructions = 0; ///< without END
  std::uint32_t aluInstructions = 0;
  std::uint32_t texInstructions = 0; ///< TEX, TXP, TXB, KIL
  std::uint32_t texIndirections = 0; ///< starts at 1 (3.11.6)
  std::uint32_t temporaries = 0;
  std::uint32_t parameters = 0;
  std::uint32_t attribs = 0;
  std::uint32_t addressRegisters = 0; ///< for vertex programs
  bool operator==(const ResourceCounts &) const = default;
};

/// How a card's native counts are made. With Documented, they are the API's counts, and the limits
/// are published numbers. The others are models of the chip (hw/native.h), named as in
/// hw/choices.def.
enum class NativeModel : std::uint8_t { Documented, R300, Nv30, I915, Nv35 };

/// Limits of one target of a profile. Every number is a row of a profile with its source
/// (src/fp_compiler/hw/profiles/).
struct Limits {
  ResourceCounts api;    ///< GL_MAX_PROGRAM_*_ARB
  ResourceCounts native; ///< GL_MAX_PROGRAM_NATIVE_*_ARB
  std::uint32_t localParameters = 0;
  std::uint32_t envParameters = 0;
  std::uint32_t textureCoords = 0;     ///< GL_MAX_TEXTURE_COORDS_ARB
  std::uint32_t textureImageUnits = 0; ///< GL_MAX_TEXTURE_IMAGE_UNITS_ARB
  std::uint32_t textureUnits = 0;      ///< GL_MAX_TEXTURE_UNITS: fixed-function units
  std::uint32_t programMatrices = 0;
  std::uint32_t programMatrixStackDepth = 0;
  std::uint32_t lights = 8;
  std::uint32_t drawBuffers = 1;
  std::uint32_t paletteMatrices = 0; ///< 0: ARB_matrix_palette is absent
  /// 1: a program over api.texIndirections does not load (3.11.3.6). 0: it loads with a warning and
  /// is not native, as under drivers that report the limit and do not enforce it.
  std::uint32_t refuseIndirections = 1;
  /// The registers of ATI fragment shaders hold [-n, n] and clamp to it. 0: they hold any float.
  std::uint32_t atiRegisterRange = 0;
  std::uint32_t vertexUnits = 1;    ///< modelview[n]; 1: ARB_vertex_blend is absent
  std::uint32_t clipPlanes = 6;     ///< GL_MAX_CLIP_PLANES: state.clip[n]
  std::uint32_t vertexAttribs = 16; ///< GL_MAX_VERTEX_ATTRIBS_ARB: vertex.attrib[n]
  /// NVIDIA's options that programs may use (ir::NvOption): 0 none, 1 NV_fragment_program or
  /// NV_vertex_program2, 2 also their successors.
  std::uint32_t nvOptions = 0;
  /// 1: NV_vertex_program and NV_vertex_program1_1 are offered, with their languages and commands.
  std::uint32_t nvVertexProgram = 0;
  NativeModel nativeModel = NativeModel::Documented;
  /// 1: the chip samples rectangle textures at [0,1], so each sample needs a MUL before it.
  std::uint32_t scaleRectangles = 0;
  /// Limits of nvparse's texts. General combiner stages (0: NV_register_combiners is not offered),
  /// 1 if NV_register_combiners2 is offered, and how many of NV_texture_shader, 2 and 3.
  std::uint32_t generalCombiners = 0;
  std::uint32_t perStageConstants = 0;
  std::uint32_t textureShaders = 0;
  /// The card's name in messages, "ATI Radeon 9700 (r300)"; empty: none. Lives as long as the
  /// process.
  const char *card = "";
};

/// Limits of the text itself, for every profile. A program string is untrusted input.
inline constexpr std::uint32_t kMaxTextBytes = 1u << 20;
inline constexpr std::uint32_t kMaxIdentifierBytes = 1024;
inline constexpr std::uint32_t kMaxNumeralBytes = 64;
inline constexpr std::uint32_t kMaxDiagnostics = 100;

} // namespace arbiter::fp
