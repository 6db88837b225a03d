#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "fp_compiler/ir/interface.h"
#include "fp_compiler/numerics.h"

/// A checked program as GLSL: what the emitter gives, and what it may use of a host.
namespace arbiter::fp {

/// One sampler of the emitted GLSL.
struct GlslSampler {
  std::string uniform; ///< "arb_tex3"
  std::uint8_t unit = 0;
  ir::TexTarget target = ir::TexTarget::Tex2D;
};

/// One element of the uniform array, which the layer must fill. State that GLSL 1.20 offers as a
/// trustworthy built-in is not here (the text reads the built-in), nor are constants, except among
/// the rows of an array that is read by address.
struct GlslUniform {
  ir::Parameter parameter;
};

/// One generic attribute of a vertex shader, for glBindAttribLocation before the link.
struct GlslAttribute {
  std::string name;       ///< "arb_attrib7"
  std::uint8_t index = 0; ///< of vertex.attrib[]: 1 and up, as attribute 0 is gl_Vertex
};

/// A GLSL 1.20 shader of one stage. It can be linked alone, when the other stage is
/// fixed function, or with the other stage's; the two share no names.
struct GlslShader {
  std::string text;
  /// Element i of `uniform vec4 arb_vparam[N]` in a vertex shader, `arb_param[N]` in a fragment
  /// one.
  std::vector<GlslUniform> uniforms;
  std::vector<GlslSampler> samplers;
  std::vector<GlslAttribute> attributes; ///< vertex shaders: those that the text declares
  bool writesDepth = false;
  bool kills = false;
};

/// What the emitter may use of its host.
struct GlslHost {
  bool textureRectangle = true;     ///< GL_ARB_texture_rectangle
  bool fragCoordConventions = true; ///< GL_ARB_fragment_coord_conventions
  bool drawBuffers = true;
  /// Vertex programs: write gl_ClipVertex, without which user clip planes do nothing, or are taken
  /// for planes of clip space, as Mesa does. It costs the host an output a vertex, planes or not;
  /// a text that is drawn with every plane disabled can do without.
  bool clipPlanes = true;
  /// Vertex programs that clip by distances (ir::Options::clipsByDistances()), with clipPlanes: a
  /// bit for each plane that is enabled, whose gl_ClipDistance is written, in GLSL 1.30. Hosts clip
  /// by what is written, enabled or not. 0 where the host has no such version.
  std::uint8_t clipDistances = 0;
  /// A bit for each image unit that reads depths with DEPTH_TEXTURE_MODE ALPHA, for programs that
  /// are linked to a GLSL 1.30 text: beside it Mesa reads them as INTENSITY.
  std::uint32_t alphaDepths = 0;
  /// Fragment programs, of points drawn as sprites: a bit for each texture coordinate that is
  /// (s, t) over the point beside the vertex's r over q, or s over q with `spriteS`; the host does
  /// not replace it.
  std::uint8_t spriteUnits = 0;
  bool spriteS = false;
  /// GL_EXT_gpu_shader4 and GL_ARB_shader_bit_encoding: integers, and the bits of a float, which
  /// Numerics::Fp24 is written in.
  bool bitEncoding = true;
  /// Fixed function's fog coordinate by FRAGMENT_DEPTH is what lies before the eye below 0, not its
  /// distance: the fog options of fragment programs take its absolute value, as the host's own
  /// programs do.
  bool negativeFogDistances = false;
};

/// The mode that a host can be given: Fp24 is Legacy where it lacks what that needs.
[[nodiscard]] Numerics numericsOn(const GlslHost &host, Numerics asked);

/// Optimises a copy of the program and writes it as GLSL. Requires a program that ir::validate()
/// accepts; cannot fail on one.
/// \param numerics the mode that is asked for; numericsOn() and ir::numericsOf() are applied
[[nodiscard]] GlslShader emitGlsl(const ir::Program &program, const GlslHost &host = {},
                                  Numerics numerics = Numerics::Host);

/// The pass pipeline of opt/ over the program, until nothing moves. The result means the same in
/// that mode; in another one it may not.
void optimise(ir::Program &program, Numerics numerics = Numerics::Host);

} // namespace arbiter::fp
