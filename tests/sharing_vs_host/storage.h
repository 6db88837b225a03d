#pragma once
#include <cstdio>
#include <functional>
#include <vector>

#include <epoxy/gl.h>

#include "../rasterizer_vs_host/surface.h"

/// What the scenes of sharing-storage draw with: textures of one colour, drawn by a fragment
/// program that the rasterizer takes, and a target that they are sampled to.
namespace storage {

inline constexpr int kEdge = 16; ///< of textures and the target, in texels

/// A context without a window, with what makeObjects() makes. Ends the process with 77 without one.
void open();
/// The programs and the target, in the current context.
void makeObjects();
/// Ends the process as one that the host has nothing for.
[[noreturn]] void skip(const char *why);

[[nodiscard]] GLuint makeTexture(bool immutable);
/// Of all of a texture that makeTexture(true) made.
[[nodiscard]] GLuint viewOf(GLuint texture);
/// Sampled without a filter; it stays bound.
void unfiltered(GLuint texture);
[[nodiscard]] GLuint framebufferOf(GLuint texture);
/// One rectangle over all of the draw framebuffer, red as `value`.
void drawFilled(int value);
/// The same of a texture, which stays attached to the draw framebuffer.
void fill(GLuint texture, int value);
/// Samples the texture over the target and records that.
void show(GLuint texture, const char *name);

/// A program of the application's own whose fragments are shaded by `text`.
[[nodiscard]] GLuint makeShaders(const char *text);
/// Draws with it over the target; `prepare` is called before it is used.
void runShaders(GLuint program, const std::function<void()> &prepare);
/// Does it in a context of the core profile that shares the objects, and comes back.
void inCoreContext(const std::function<void()> &what);

// --- Scenes of what lies outside GL: storage_outside.cpp ---

/// Two textures in memory that was imported.
void importedMemory();
/// As open(), in a window of X.
void openScreen();
/// A pixmap's colours as a texture (GLX_EXT_texture_from_pixmap). Requires: openScreen().
void boundPixmap();

} // namespace storage
