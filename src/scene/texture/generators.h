#pragma once
#include "scene/panel/panel.h"
#include "scene/texture/image.h"

/// One function a generator; generate.cpp chooses. The same texels at every call.
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

/// Two texels wide (the cell is dead, or alive) and sixteen high (how many of nine are alive). Red
/// is the cell's next state; the other components colour it.
[[nodiscard]] Image makeRule();

/// 16 bits: 32768 is no displacement, 65535 almost one half of the texture.
[[nodiscard]] Image makeTwirl(const TextureSource &source, int width, int height);
[[nodiscard]] Image makeRipple(const TextureSource &source, int width, int height);

/// Tangent-space normals, n as 0.5 + 0.5 * n, of heights in red; alpha is the height.
[[nodiscard]] Image makeNormals(const Image &heights, float strength);

/// Six faces in GL's order: +x, -x, +y, -y, +z, -z.
[[nodiscard]] std::vector<Image> makeNormalise(int side);
[[nodiscard]] std::vector<Image> makeSky(const TextureSource &source, int side);

} // namespace arbiter::scene
