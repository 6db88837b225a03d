#pragma once
#include <functional>

/// Single bitmaps and images of rasterizer-bitmaps, in a context that is current.
namespace software {

constexpr int kEdge = 64; ///< of the target, in pixels

/// Draws what the specification says and hosts do not all do: run_bitmaps.py knows the colours.
void rules();
/// Draws a bitmap and an image in fog, in frames that are the host's for another draw.
void frames(const std::function<void()> &swap);
/// Draws bitmaps of a program that samples. It is current no more, or there is none, when `draw`
/// comes.
void letters(int change, int draw);

} // namespace software
