#pragma once
#include <array>
#include <cstdint>
#include <string_view>

/// The interface between a program and GL: attributes, results, parameters, rows of state, texture
/// targets, options. The code itself is in ir.h, which few of the files that draw need.
namespace arbiter::fp::ir {

struct Program;

/// The language that a program was written in. ATI's text form and its API form are one language.
/// The last two occur only as texts: !!RC1.0, and !!TS1.0 with or without a !!RC1.0 after it. Their
/// programs have the language ArbFragment.
enum class Language : std::uint8_t {
  ArbFragment,
  ArbVertex,
  AtiFragment,
  Combiners,
  TextureShaders
};
/// True for one of nvparse's languages.
[[nodiscard]] constexpr bool isNvparse(Language language) {
  return language == Language::Combiners || language == Language::TextureShaders;
}

using Vec4 = std::array<float, 4>;

enum class TexTarget : std::uint8_t {
  Tex1D,
  Tex2D,
  Tex3D,
  Cube,
  Rect,
  Shadow1D,
  Shadow2D,
  ShadowRect
};

/// Fragment attributes (ARB_fragment_program 3.11.3.1, table X.2) and vertex attributes
/// (ARB_vertex_program 2.14.3.1, table X.2). Only TexCoord and Generic use `index`.
enum class AttributeKind : std::uint8_t {
  ColorPrimary,
  ColorSecondary,
  TexCoord,
  FogCoord,
  Position, ///< fragment.position (window), or vertex.position (object space)
  Normal,   ///< vertex programs: (x,y,z,1)
  Generic,  ///< vertex.attrib[index]; attrib[0] stays generic, its value is the position
  Facing,   ///< fragment.facing of NV_fragment_program2: (1, 0, 0, 1), with x = -1 for a back face
};
struct Attribute {
  AttributeKind kind = AttributeKind::ColorPrimary;
  std::uint8_t index = 0;
  bool operator==(const Attribute &) const = default;
};

/// Returns the number of the generic attribute that shares a register with a conventional one
/// (ARB_vertex_program, table X.2.1). Returns 0 for the position, which is generic attribute 0, and
/// for everything that is not a conventional vertex attribute.
[[nodiscard]] constexpr unsigned genericNumberOf(const Attribute &attribute) {
  switch (attribute.kind) {
  case AttributeKind::Normal:
    return 2;
  case AttributeKind::ColorPrimary:
    return 3;
  case AttributeKind::ColorSecondary:
    return 4;
  case AttributeKind::FogCoord:
    return 5;
  case AttributeKind::TexCoord:
    return 8u + attribute.index;
  default:
    return 0;
  }
}

enum class OutputKind : std::uint8_t {
  Color, ///< result.color[index] of a fragment program
  Depth, ///< result.depth; the value is component z (index 2) of the register
  // Vertex results (ARB_vertex_program table X.4).
  Position,
  FrontPrimary,
  FrontSecondary,
  BackPrimary,
  BackSecondary,
  FogCoord,     ///< component x
  PointSize,    ///< component x
  TexCoord,     ///< result.texcoord[index]
  EnvParameter, ///< program parameter c[index], written by a vertex state program
  /// result.clip[index] of NVIDIA's options, component x. If CLIP_PLANE<index> is enabled, the
  /// vertex is outside where it is below 0 or NaN. Position-invariant programs do not have it,
  /// because the planes themselves clip them (NV_vertex_program2_option, section 2.11).
  ClipDistance,
};
struct Output {
  OutputKind kind = OutputKind::Color;
  std::uint8_t index = 0;
  bool operator==(const Output &) const = default;
};

/// The kinds of rows of GL state (ARB_fragment_program 3.11.3.2, tables X.2.2 to X.2.7;
/// ARB_vertex_program 2.14.3.2, tables X.3.2 to X.3.8).
enum class StateItem : std::uint8_t {
  MaterialAmbient,
  MaterialDiffuse,
  MaterialSpecular,
  MaterialEmission,
  MaterialShininess,
  LightAmbient,
  LightDiffuse,
  LightSpecular,
  LightPosition,
  LightAttenuation,
  LightSpotDirection,
  LightHalf,
  LightModelAmbient,
  LightModelSceneColor,
  LightProdAmbient,
  LightProdDiffuse,
  LightProdSpecular,
  TexEnvColor,
  FogColor,
  FogParams,
  DepthRange,
  MatrixModelview,
  MatrixProjection,
  MatrixMvp,
  MatrixTexture,
  MatrixPalette,
  MatrixProgram,
  // For vertex programs only.
  TexGenEye,        ///< plane of coordinate `row` (s, t, r, q) of unit `index`
  TexGenObject,     ///< plane of coordinate `row` of unit `index`
  ClipPlane,        ///< plane `index`, in eye coordinates
  PointSize,        ///< (size, smallest, largest, fade threshold)
  PointAttenuation, ///< (constant, linear, quadratic, 1)
  // No language has a name for it.
  FogFactors, ///< computed from FogParams (ir/fog.h)
};
enum class MatrixModifier : std::uint8_t { Plain, Inverse, Transpose, InvTrans };

struct StateRef {
  StateItem item = StateItem::MaterialAmbient;
  bool back = false;      ///< the back face's material, scene colour or light product
  std::uint8_t index = 0; ///< light, texture unit, clip plane, or matrix number
  MatrixModifier modifier = MatrixModifier::Plain;
  std::uint8_t row = 0; ///< row 0..3 of a matrix; coordinate of a TexGen
  bool operator==(const StateRef &) const = default;
};

enum class ParameterKind : std::uint8_t { Constant, Env, Local, State };
/// A vec4 row that the program may read.
struct Parameter {
  ParameterKind kind = ParameterKind::Constant;
  Vec4 constant = {};      ///< Constant
  std::uint16_t index = 0; ///< Env, Local
  StateRef state;          ///< State
};

enum class FogMode : std::uint8_t { None, Exp, Exp2, Linear };
/// The NVIDIA option that the program is written under. Each includes the one before it.
enum class NvOption : std::uint8_t { None, First, Second };
/// The NVIDIA language that a program is written in, by its header: !!FP1.0 (NV_fragment_program),
/// !!VP1.0 and !!VSP1.0 (NV_vertex_program), !!VP1.1 (NV_vertex_program1_1), !!VP2.0
/// (NV_vertex_program2). None stands for the languages of the ARB and of ATI.
enum class NativeLanguage : std::uint8_t { None, Fp1, Vp1, Vp11, Vp2, Vsp1 };
/// Returns the header, such as "!!FP1.0"; empty for None.
[[nodiscard]] constexpr std::string_view headerOf(NativeLanguage language) {
  constexpr std::string_view kHeaders[] = {"",        "!!FP1.0", "!!VP1.0",
                                           "!!VP1.1", "!!VP2.0", "!!VSP1.0"};
  return kHeaders[std::size_t(language)];
}
enum class Precision : std::uint8_t { Unspecified, Fastest, Nicest };

/// The program's options (3.11.4.5).
struct Options {
  FogMode fog = FogMode::None;
  Precision precision = Precision::Unspecified;
  bool shadow = false;             ///< ARB_fragment_program_shadow
  bool drawBuffers = false;        ///< ARB_draw_buffers / ATI_draw_buffers
  bool originUpperLeft = false;    ///< ARB_fragment_coord_conventions
  bool pixelCenterInteger = false; ///< ARB_fragment_coord_conventions
  bool positionInvariant = false;  ///< ARB_position_invariant: no result.position in the code
  /// True if the secondary colour's rgb is added to the result before fog, as COLOR_SUM does. For
  /// ATI fragment shaders it follows the state that they are drawn under.
  bool colorSum = false;
  /// First: NV_fragment_program or NV_vertex_program2. Second: NV_fragment_program2 or
  /// NV_vertex_program3.
  NvOption nv = NvOption::None;
  /// If it is not None, `nv` is First, because such programs follow that option's rules.
  NativeLanguage native = NativeLanguage::None;

  /// True for a vertex program whose vertices are clipped by the distances that it writes, and not
  /// by CLIP_PLANEs' equations. This holds for all of NVIDIA's, except under an option with fixed
  /// function's position (NV_vertex_program2_option, section 2.11; NV_vertex_program, section
  /// 2.14.1).
  [[nodiscard]] constexpr bool clipsByDistances() const {
    return native != NativeLanguage::None || (nv != NvOption::None && !positionInvariant);
  }
  bool operator==(const Options &) const = default;
};

} // namespace arbiter::fp::ir
