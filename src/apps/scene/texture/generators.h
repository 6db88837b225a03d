#pragma once
#include "apps/scene/panel/panel.h"
#include "apps/scene/texture/image.h"

/// Makes generated images, one function for each generator; generate.cpp selects one. Each call
/// gives the same texels.
namespace arbiter::scene {

[[nodiscard]] Image makeConstant(const TextureSource &source, int width, int height);
[[nodiscard]] Image makeChecker(const TextureSource &source, int width, int height);
[[nodiscard]] Image makeNoise(int width, int height);
[[nodiscard]] Image makeClouds(const TextureSource &source, int width, int height);
[[nodiscard]] Image makeGradient(const TextureSource &source, int width, int height);
[[nodiscard]] Image makeSpot(const TextureSource &source, int width, int height);
[[nodiscard]] Image makeBricks(const TextureSource &source, int width, int height);
[[nodiscard]] Image makeBumps(const TextureSource &source, int width, int height);
[[nodiscard]] Image makeHairs(const TextureSource &source, int width, int height);
[[nodiscard]] Image makeCells(const TextureSource &source, int width, int height);
[[nodiscard]] Image makeLandscape(int width, int height);

/// Makes the rule of Life. It is two texels wide (the cell is dead, or alive) and sixteen high (how
/// many of nine are alive). Red is the cell's next state, and the other components color it.
[[nodiscard]] Image makeRule();

/// Makes 16-bit displacements: 32768 is none, 65535 almost half of the texture.
[[nodiscard]] Image makeTwirl(const TextureSource &source, int width, int height);
[[nodiscard]] Image makeRipple(const TextureSource &source, int width, int height);

/// Makes tangent-space normals, n as 0.5 + 0.5 * n, from heights in red; alpha is the height.
[[nodiscard]] Image makeNormals(const Image &heights, float strength);

/// Makes six faces in GL's order: +x, -x, +y, -y, +z, -z.
[[nodiscard]] std::vector<Image> makeNormalize(int side);
[[nodiscard]] std::vector<Image> makeSky(const TextureSource &source, int side);

} // namespace arbiter::scene
