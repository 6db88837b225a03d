#pragma once
#include <array>
#include <vector>

#include "fp_compiler/ir/evaluate.h"

/// The GL state of every program of the suite, in two forms: as the values that the interpreter
/// reads, and as calls that set it in a context.
namespace arbiter::differential {

using fp::ir::Vec4;

/// Returns the value of an Env, Local or State row.
[[nodiscard]] Vec4 parameterValue(const fp::ir::Parameter &parameter);

/// Returns the exact value of an attribute, which is affine in the window's coordinates.
/// \param x, y window coordinates, pixel centers at .5
[[nodiscard]] Vec4 attributeValue(const fp::ir::Attribute &attribute, float x, float y);

/// Samples the scene's textures at the nearest texel, by the GL specification.
[[nodiscard]] Vec4 sampleTexture(const fp::ir::Sample &sample);

/// Sets lights, materials, fog, matrices and texture environments. Needs a current context.
/// \param programMatrices includes the matrices of ARB_fragment_program
void applyState(bool programMatrices);

/// Returns GL's name of a target; for a comparing target that of the texture.
[[nodiscard]] unsigned textureTarget(fp::ir::TexTarget target);

/// Makes the texture objects and binds them to their units.
/// \param assembly true if programs are texts or ATI's calls, not GLSL
void applyTextures(bool assembly = false);
/// Sets the env parameters. \param target GL_FRAGMENT_PROGRAM_ARB or GL_VERTEX_PROGRAM_ARB
void applyEnvParameters(unsigned target);
/// Sets the local parameters of the target's bound program.
void applyLocalParameters(unsigned target);

/// Returns a vertex's value of a vertex program's attribute. The position is the center of pixel
/// (x, y) in clip coordinates; the rest is arbitrary.
[[nodiscard]] Vec4 vertexValue(const fp::ir::Attribute &attribute, int x, int y);

/// Draws one point for each pixel of the window, with every conventional attribute and the generic
/// ones that the program reads. On other hosts they may alias (ARB_vertex_program, table X.1), and
/// no program reads both.
void drawPoints(const fp::ir::Program &program);
/// Draws the points with every generic attribute.
void drawPoints();

/// Covers the window with one quad that has every attribute.
void drawQuad();

} // namespace arbiter::differential
