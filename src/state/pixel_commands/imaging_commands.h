#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <GL/gl.h>

#include "state/imaging/pixels.h"

/// The commands of ARB_imaging that set its state, below the entry points: as they are called, or
/// as a display list has them.
namespace arbiter::state {

class Context;
struct Command;

/// One command with its arguments. Plain bytes, in which a list keeps it, and colours behind them.
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
    FilterParameter, ///< target, pname, values; flag: of one number
    Histogram,       ///< target, pname: the internal format, width, flag: sink
    Minmax,          ///< target, pname, flag
    Reset,           ///< target
    Transfer,        ///< pname, values[0]
    MatrixMode,      ///< pname
    DrawPixels,      ///< width, height, flag: were colour indices; colours
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

/// Executes it, or records it into the list that is compiled. From then on the context's pixel
/// commands ask for imaging.
void issueImaging(Context &context, const ImagingCommand &command,
                  const std::vector<imaging::Rgba> &colors = {});
/// The same at once, in a list that is compiled too: commands of proxies (5.4).
void executeImaging(Context &context, const ImagingCommand &command,
                    const std::vector<imaging::Rgba> &colors);
/// A list's.
void executeImaging(Context &context, const Command &command);
/// Into the list that is compiled; `head` is a command's or an upload's plain bytes.
void recordImaging(Context &context, const ImagingCommand &command, const std::string &more,
                   const std::vector<imaging::Rgba> &colors);
/// Pixel commands of the context look at imaging from now on, and its lists are the layer's.
void noteImagingUse(Context &context);

} // namespace arbiter::state
