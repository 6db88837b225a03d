#pragma once
#include <array>

#include <GL/gl.h>

#include "state/imaging/color_matrix.h"
#include "state/imaging/pipeline.h"

namespace arbiter::state {

class Context;

/// The sizes of a proxy; zero for what there is no room for.
struct ProxyTable {
  GLenum format = GL_RGBA;
  GLsizei width = 0;
  bool sink = false;
};

/// ARB_imaging in a context, where the layer has it. What is set here is used by the commands of
/// pixel_commands/imaging_commands.h, and applied to pixels by those of
/// pixel_commands/pixel_commands.h.
struct ImagingState {
  static constexpr GLsizei kMostEntries = 4096; ///< of a table, and of a histogram
  static constexpr GLsizei kMostFilter = 11;    ///< MAX_CONVOLUTION_WIDTH and _HEIGHT

  imaging::Settings settings;
  imaging::Contents contents;
  std::array<ProxyTable, 3> proxyTables;
  ProxyTable proxyHistogram;
  ColorMatrix colorMatrix;

  /// Pixels are changed or counted by any of it.
  [[nodiscard]] bool isActive(Context &context);
};

/// The number of a table's target, of a proxy's with `proxy` set; -1: none.
[[nodiscard]] int tableOf(GLenum target, bool &proxy);
/// 0 to 2 for CONVOLUTION_1D, CONVOLUTION_2D and SEPARABLE_2D; -1: none.
[[nodiscard]] int filterTargetOf(GLenum target);
/// The bit of an Enable; 0: none of ARB_imaging.
[[nodiscard]] unsigned imagingBitOf(GLenum cap);
/// The value of a PixelTransfer of ARB_imaging; null: none.
[[nodiscard]] float *imagingTransfer(imaging::Settings &settings, GLenum pname);
/// Values of GetFloatv and its kin: how many; 0: the host's to answer.
[[nodiscard]] int imagingValues(Context &context, GLenum pname, std::array<GLfloat, 16> &values);

} // namespace arbiter::state
