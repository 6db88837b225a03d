#pragma once
#include "allocations.h"

/// Shared parts of the scenes of rasterizer-allocations: programs, textures and a quad.
namespace memory {

[[nodiscard]] GLuint load(GLenum target, const std::string &text);
/// Returns a text of the same meaning that no program had before.
[[nodiscard]] std::string fresh(const std::string &body, const char *header, int round);
inline constexpr const char *kFragment = "TEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
                                         "MAD t, t, program.env[1], program.local[2];\n"
                                         "MUL result.color, t, fragment.color;\n";
inline constexpr const char *kVertex = "PARAM m[4] = { state.matrix.mvp };\n"
                                       "DP4 result.position.x, m[0], vertex.position;\n"
                                       "DP4 result.position.y, m[1], vertex.position;\n"
                                       "DP4 result.position.z, m[2], vertex.position;\n"
                                       "DP4 result.position.w, m[3], vertex.position;\n"
                                       "MUL result.color, vertex.color, program.local[0];\n"
                                       "MOV result.texcoord[0], vertex.texcoord[0];\n";
void setParameters();
void enablePrograms();

[[nodiscard]] std::vector<unsigned char> texelsOf(int side, int seed);
/// Makes a texture, which stays bound.
[[nodiscard]] GLuint makeTexture(int side, int seed);
/// An offset of texture coordinates, so that no pixel samples where two texels meet. There the
/// host, which draws when memory runs out, and the rasterizer could choose different texels.
inline constexpr float kOff = 0.007f;
/// Draws a quad over all rows, between two places of the x axis in clip space.
void quad(float left = -1, float right = 1);

/// Objects that all frames use, made while there is memory.
struct Kept {
  GLuint fragment, vertex, texture, list, buffer;
};
extern Kept g_kept;
void makeKept(Surface &);
void useKept();
/// Takes the present error. If it tells that memory ran out, the frame counts as refused.
GLenum takeErrorOf(Surface &window);

// --- draw_scenes.cpp ---
[[nodiscard]] Pixels programs(Surface &window, int round);
[[nodiscard]] Pixels compiles(Surface &window, int round);
[[nodiscard]] Pixels draws(Surface &, int);
[[nodiscard]] Pixels manyTriangles(Surface &, int round);
[[nodiscard]] Pixels lists(Surface &, int round);
[[nodiscard]] Pixels fragmentShaders(Surface &, int);
[[nodiscard]] Pixels named(Surface &, int round);

// --- image_scenes.cpp ---
[[nodiscard]] Pixels copies(Surface &, int);
[[nodiscard]] Pixels textures(Surface &, int round);
[[nodiscard]] Pixels shown(Surface &window, int round);
[[nodiscard]] Pixels contexts(Surface &window, int);
[[nodiscard]] Pixels firstDraws(Surface &window, int round);

} // namespace memory
