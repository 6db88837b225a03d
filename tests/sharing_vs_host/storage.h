#pragma once
#include <cstdio>
#include <functional>
#include <vector>

#include <epoxy/gl.h>

#include "../rasterizer_vs_host/surface.h"

/// Shared parts of the scenes of sharing-storage: textures of one color, drawn by a fragment
/// program that the rasterizer supports, and a target that samples are written to.
namespace storage {

inline constexpr int kEdge = 16; ///< of textures and the target, in texels

/// Makes a context without a window, and calls makeObjects(). Exits the process with 77 if there is
/// none.
void open();
/// Makes the programs and the target in the current context.
void makeObjects();
/// Exits the process, as the host lacks something.
[[noreturn]] void skip(const char *why);

[[nodiscard]] GLuint makeTexture(bool immutable);
/// Makes a view of all of a texture that makeTexture(true) made.
[[nodiscard]] GLuint viewOf(GLuint texture);
/// Sets sampling without a filter; the texture stays bound.
void unfiltered(GLuint texture);
[[nodiscard]] GLuint framebufferOf(GLuint texture);
/// Draws one rectangle over the whole draw framebuffer, with red `value`.
void drawFilled(int value);
/// Fills a texture, which stays attached to the draw framebuffer.
void fill(GLuint texture, int value);
/// Samples the texture over the target and records that.
void show(GLuint texture, const char *name);

/// Makes a GLSL program of the application whose fragment shader is `text`.
[[nodiscard]] GLuint makeShaders(const char *text);
/// Draws with it over the target; `prepare` is called before it is used.
void runShaders(GLuint program, const std::function<void()> &prepare);
/// Calls `what` in a core profile context that shares the objects, then returns to the present
/// context.
void inCoreContext(const std::function<void()> &what);

// --- Scenes of what lies outside GL: storage_outside.cpp ---

/// Tests two textures in imported memory.
void importedMemory();
/// Does what open() does, in an X window.
void openScreen();
/// Tests a pixmap's colors as a texture (GLX_EXT_texture_from_pixmap). Requires openScreen().
void boundPixmap();

} // namespace storage
