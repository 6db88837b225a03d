#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <GL/gl.h>

#include "state/imaging/pixels.h"

/// The commands of ARB_imaging that set its state. Entry points and display lists call them.
namespace arbiter::state {

struct RasterContext;
struct Command;

/// A command and its arguments. A list keeps its bytes, followed by its colours.
struct ImagingCommand {
  enum class Kind : std::uint8_t {
    Enable,          ///< pname, flag
    Table,           ///< target, pname: the internal format; colours
    SubTable,        ///< target, x: the first entry; colours
    CopyTable,       ///< target, pname; x, y, width
    CopySubTable,    ///< target, start; x, y, width
    TableParameter,  ///< target, pname, values
    Filter,          ///< target, pname: the internal format, width, height; colours: the image, or
                     ///< the row and then the column
    CopyFilter,      ///< target, pname; x, y, width, height
    FilterParameter, ///< target, pname, values; flag: set by a command with one value
    Histogram,       ///< target, pname: the internal format, width, flag: sink
    Minmax,          ///< target, pname, flag
    Reset,           ///< target
    Transfer,        ///< pname, values[0]
    MatrixMode,      ///< pname
    DrawPixels,      ///< width, height, flag: colour indices; colours
    CopyPixels,      ///< x, y, width, height, pname: the type
    TexImage,        ///< bytes: an ImageUpload (pixel_commands.h); colours
  };
  Kind kind = Kind::Enable;
  bool flag = false;
  GLenum target = 0, pname = 0;
  GLint start = 0, x = 0, y = 0;
  GLsizei width = 0, height = 1;
  imaging::Rgba values{};
};

/// Executes the command, or records it in a list. From then on the context's pixel commands check
/// imaging.
void issueImaging(RasterContext &context, const ImagingCommand &command,
                  const std::vector<imaging::Rgba> &colors = {});
/// Executes the command at once, even in a list: commands of proxies (5.4).
void executeImaging(RasterContext &context, const ImagingCommand &command,
                    const std::vector<imaging::Rgba> &colors);
/// Executes a list's command.
void executeImaging(RasterContext &context, const Command &command);
/// Records a command in a list, with an upload's bytes or nothing in `more`.
void recordImaging(RasterContext &context, const ImagingCommand &command, const std::string &more,
                   const std::vector<imaging::Rgba> &colors);
/// Makes the context's pixel commands check imaging from now on, and its lists the layer's.
void noteImagingUse(RasterContext &context);

} // namespace arbiter::state
