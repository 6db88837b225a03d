#pragma once
#include <functional>

/// Single bitmaps and images of rasterizer-bitmaps, in the current context.
namespace software {

constexpr int kEdge = 64; ///< of the target, in pixels

/// Draws what the specification defines but not all hosts implement; bitmaps.py knows the
/// colors.
void rules();
/// Draws a bitmap and an image in fog, in frames that are the host's because of another draw.
void frames(const std::function<void()> &swap);
/// Draws bitmaps with a program that samples. It is no longer current, or deleted, at the time of
/// `draw`.
void letters(int change, int draw);

} // namespace software
