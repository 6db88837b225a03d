#pragma once
#include <epoxy/gl.h>

/// Makes an OpenGL context without a window system current: on Mesa's surfaceless platform, or on
/// the display of the only device. Returns false if there is none.
[[nodiscard]] bool openContext();

/// Makes a context current that offers the extension; prints on stderr why there is none.
[[nodiscard]] bool openContextWith(const char *extension);
/// Binds a framebuffer object of that color format with 24 bits of depth, undithered.
void bindTarget(int width, int height, GLenum format = GL_RGBA8);
/// The exit status of a client that has nothing to test.
inline constexpr int kSkipped = 77;
