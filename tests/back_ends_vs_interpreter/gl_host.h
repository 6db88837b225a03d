#pragma once
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <optional>
#include <string>
#include <vector>

namespace arbiter::differential {

/// Side of the square window in pixels; one fragment each.
inline constexpr int kSide = 16;
inline constexpr int kColorBuffers = 2;

/// A compatibility context without a window, current on this thread while the object lives.
/// EGL on Mesa's surfaceless platform, or on the default display if there is none.
class GlHost {
public:
  /// Empty, with the reason in \p why, if no context can be made.
  static std::optional<GlHost> create(std::string &why);
  GlHost(GlHost &&other) noexcept;
  GlHost &operator=(GlHost &&) = delete;
  ~GlHost();

private:
  GlHost() = default;
  EGLDisplay m_display = EGL_NO_DISPLAY;
  EGLContext m_context = EGL_NO_CONTEXT;
};

struct Pixels {
  std::vector<float> rgba;  ///< kSide * kSide * 4, row 0 at the bottom
  std::vector<float> depth; ///< kSide * kSide
};

/// Float colour buffers and a float depth buffer, so that nothing is clamped or rounded.
class FloatTarget {
public:
  /// False if the host lacks float buffers.
  [[nodiscard]] bool create();
  void clear() const;
  [[nodiscard]] Pixels read(int buffer) const;

private:
  GLuint m_framebuffer = 0;
};

/// What clear() leaves in a colour buffer: a value that no program makes.
inline constexpr float kUntouched = 777.0f;

/// Whether the host's shaders compute with denormals, as they may, where the interpreter takes them
/// for zeros: Debian's Mesa of 32 bits is compiled for processors that cannot be told to. Draws
/// once, and leaves the state as it was.
[[nodiscard]] bool keepsDenormals();
/// `value`, or the zero of its sign where it is a denormal and the host keeps those.
[[nodiscard]] float comparable(float value);

/// Whether the layer is preloaded: the host's vendor library alone is opened in a scope of its own.
[[nodiscard]] bool layerInFront();

/// GL errors since the last call, as text; empty if there were none.
[[nodiscard]] std::string takeErrors();

} // namespace arbiter::differential
