#pragma once
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <optional>
#include <string>
#include <vector>

namespace arbiter::differential {

/// The width and height of the window in pixels; each is one fragment.
inline constexpr int kSide = 16;
inline constexpr int kColorBuffers = 2;

/// A compatibility context without a window, current on this thread while the object lives. It uses
/// EGL on Mesa's surfaceless platform, or on the default display if there is none.
class GlHost {
public:
  /// Creates a context. Returns nothing, with the reason in \p why, if it cannot.
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

/// A target with float color buffers and a float depth buffer, so that nothing is clamped or
/// rounded.
class FloatTarget {
public:
  /// Returns false if the host lacks float buffers.
  [[nodiscard]] bool create();
  void clear() const;
  [[nodiscard]] Pixels read(int buffer) const;

private:
  GLuint m_framebuffer = 0;
};

/// The value that clear() writes to a color buffer; no program computes it.
inline constexpr float kUntouched = 777.0f;

/// True if the host's shaders compute with denormals, which GL allows and the interpreter treats as
/// zeros: Debian's 32-bit Mesa is compiled for processors that cannot flush them. Draws once, and
/// restores the state.
[[nodiscard]] bool keepsDenormals();
/// Returns `value`, or the zero of its sign if it is a denormal and the host keeps those.
[[nodiscard]] float comparable(float value);

/// True if the layer is preloaded: the host's vendor library would be opened in a scope of its own.
[[nodiscard]] bool layerInFront();

/// Returns GL errors since the last call, as text; empty if there were none.
[[nodiscard]] std::string takeErrors();

} // namespace arbiter::differential
