#pragma once
#include <array>

#include <GL/gl.h>

#include "state/imaging/color_matrix.h"
#include "state/imaging/pipeline.h"

namespace arbiter::state {

struct CoreContext;

/// The sizes of a proxy; zero if it does not fit.
struct ProxyTable {
  GLenum format = GL_RGBA;
  GLsizei width = 0;
  bool sink = false;
};

/// The layer's ARB_imaging in a context. Commands of pixel_commands/imaging_commands.h set it, and
/// those of pixel_commands/pixel_commands.h apply it to pixels.
struct ImagingState {
  static constexpr GLsizei kMaxEntries = 4096; ///< of tables and histograms
  static constexpr GLsizei kMaxFilter = 11;    ///< MAX_CONVOLUTION_WIDTH and _HEIGHT

  imaging::Settings settings;
  imaging::Contents contents;
  std::array<ProxyTable, 3> proxyTables;
  ProxyTable proxyHistogram;
  ColorMatrix colorMatrix;

  /// True if any of it changes or counts pixels.
  [[nodiscard]] bool isActive(CoreContext &context);
};

/// Returns the index of a table's target, with `proxy` set for a proxy; -1 if it is none.
[[nodiscard]] int tableOf(GLenum target, bool &proxy);
/// Returns 0 to 2 for CONVOLUTION_1D, CONVOLUTION_2D and SEPARABLE_2D; -1 for others.
[[nodiscard]] int filterTargetOf(GLenum target);
/// Returns the bit of an Enable; 0 if it is none of ARB_imaging.
[[nodiscard]] unsigned imagingBitOf(GLenum cap);
/// Returns the PixelTransfer value of ARB_imaging; null if it is none.
[[nodiscard]] float *imagingTransfer(imaging::Settings &settings, GLenum pname);
/// Gets values for GetFloatv and the like. Returns how many; 0 if the host must answer.
[[nodiscard]] int imagingValues(CoreContext &context, GLenum pname,
                                std::array<GLfloat, 16> &values);

} // namespace arbiter::state
