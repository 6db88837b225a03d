#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "fp_compiler/ir/interface.h"
#include "fp_compiler/numerics.h"

/// Turns a checked program into GLSL: the emitter's result, and the host features that it may use.
namespace arbiter::fp {

/// A sampler of the emitted GLSL.
struct GlslSampler {
  std::string uniform; ///< "arb_tex3"
  std::uint8_t unit = 0;
  ir::TexTarget target = ir::TexTarget::Tex2D;
};

/// An element of the uniform array, which the layer must fill. State that GLSL 1.20 has as a
/// reliable built-in is not in the array, because the text reads the built-in. Constants are not in
/// it either, except in the rows of an array that is read by address.
struct GlslUniform {
  ir::Parameter parameter;
};

/// A generic attribute of a vertex shader, for glBindAttribLocation before linking.
struct GlslAttribute {
  std::string name;       ///< "arb_attrib7"
  std::uint8_t index = 0; ///< index of vertex.attrib[], from 1, because attribute 0 is gl_Vertex
};

/// A GLSL 1.20 shader of one stage. It can be linked alone, if the other stage is fixed function,
/// or with a shader of the other stage. The two have no names in common.
struct GlslShader {
  std::string text;
  /// Element i of `uniform vec4 arb_vparam[N]` in a vertex shader, or of `arb_param[N]` in a
  /// fragment shader.
  std::vector<GlslUniform> uniforms;
  std::vector<GlslSampler> samplers;
  std::vector<GlslAttribute> attributes; ///< vertex shaders: those that the text declares
  bool writesDepth = false;
  bool kills = false;
};

/// The host features that the emitter may use.
struct GlslHost {
  bool textureRectangle = true;     ///< GL_ARB_texture_rectangle
  bool fragCoordConventions = true; ///< GL_ARB_fragment_coord_conventions
  bool drawBuffers = true;
  /// Vertex programs: write gl_ClipVertex. Without it user clip planes do nothing, or the host
  /// takes them for planes in clip space, as Mesa does. It costs the host an output for each
  /// vertex, even without planes. If every plane is disabled, the text does not need it.
  bool clipPlanes = true;
  /// A bit for each enabled plane, for vertex programs that clip by distances
  /// (ir::Options::clipsByDistances()), together with clipPlanes. The text writes their
  /// gl_ClipDistance in GLSL 1.30. Hosts clip by every written distance, enabled or not. 0 if the
  /// host lacks that version.
  std::uint8_t clipDistances = 0;
  /// A bit for each image unit that reads depths with DEPTH_TEXTURE_MODE ALPHA. For programs linked
  /// to a GLSL 1.30 text, because Mesa then reads such depths as INTENSITY.
  std::uint32_t alphaDepths = 0;
  /// Fragment programs for points drawn as sprites. A bit for each texture coordinate that is
  /// replaced: (s, t) over the point with the vertex's r over q, or only s over q with `spriteS`.
  /// The text replaces them, the host does not.
  std::uint8_t spriteUnits = 0;
  bool spriteS = false;
  /// GL_EXT_gpu_shader4 and GL_ARB_shader_bit_encoding: integers, and access to a float's bits.
  /// Numerics::Fp24 needs them.
  bool bitEncoding = true;
  /// True if fixed function's fog coordinate for FRAGMENT_DEPTH is negative in front of the eye,
  /// instead of the distance. The fog options of fragment programs then take its absolute value, as
  /// the host's own programs do.
  bool negativeFogDistances = false;
};

/// Returns the mode that the host supports: Legacy in place of Fp24 if it lacks what that needs.
[[nodiscard]] Numerics numericsOn(const GlslHost &host, Numerics asked);

/// Optimises a copy of the program and emits it as GLSL. Cannot fail.
/// Requires: ir::validate() accepts the program.
/// \param numerics the mode that is asked for; numericsOn() and ir::numericsOf() are applied
[[nodiscard]] GlslShader emitGlsl(const ir::Program &program, const GlslHost &host = {},
                                  Numerics numerics = Numerics::Host);

/// Runs the passes of opt/ until nothing changes. The result means the same in that mode, but may
/// not in another one.
void optimise(ir::Program &program, Numerics numerics = Numerics::Host);

} // namespace arbiter::fp
