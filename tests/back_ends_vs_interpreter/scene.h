#pragma once
#include <array>
#include <vector>

#include "fp_compiler/ir/evaluate.h"

/// The GL state that every program of the suite runs in, twice: as the values that the interpreter
/// reads, and as calls that give a context the same.
namespace arbiter::differential {

using fp::ir::Vec4;

/// Value of an Env, Local or State row.
[[nodiscard]] Vec4 parameterValue(const fp::ir::Parameter &parameter);

/// The exact value of an attribute, which is affine in the window's coordinates.
/// \param x, y window coordinates, pixel centres at .5
[[nodiscard]] Vec4 attributeValue(const fp::ir::Attribute &attribute, float x, float y);

/// Nearest-texel sampling of the scene's textures, as the GL specification says.
[[nodiscard]] Vec4 sampleTexture(const fp::ir::Sample &sample);

/// Lights, materials, fog, matrices, texture environments. Needs a current context.
/// \param programMatrices also the matrices of ARB_fragment_program
void applyState(bool programMatrices);

/// The name that GL has for a target; of the texture, where the target compares.
[[nodiscard]] unsigned textureTarget(fp::ir::TexTarget target);

/// Texture objects on their units.
/// \param assembly programs are given as texts or ATI's calls, not as GLSL
void applyTextures(bool assembly = false);
/// \param target GL_FRAGMENT_PROGRAM_ARB or GL_VERTEX_PROGRAM_ARB
void applyEnvParameters(unsigned target);
/// For the program that is bound to the target.
void applyLocalParameters(unsigned target);

/// What one vertex has for an attribute of a vertex program: the position is the centre of pixel
/// (x, y) in clip coordinates, the rest made up.
[[nodiscard]] Vec4 vertexValue(const fp::ir::Attribute &attribute, int x, int y);

/// One point for each pixel of the window, each a vertex that carries every conventional attribute
/// and the generic ones that the program reads: elsewhere they may be the same (ARB_vertex_program,
/// table X.1), and no program reads both.
void drawPoints(const fp::ir::Program &program);
/// The same with every generic attribute.
void drawPoints();

/// Covers the window with one quad that carries every attribute.
void drawQuad();

} // namespace arbiter::differential
