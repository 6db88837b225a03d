#pragma once
#include <vector>

#include "state/pixel_commands/imaging_commands.h"

/// The functions behind commands.h, by subject. Each raises its errors.
namespace arbiter::state {

/// Return the error of a command's target, format and size, without its colours. The framebuffer is
/// not read for a command with an error.
[[nodiscard]] GLenum tableError(const ImagingCommand &command);
[[nodiscard]] GLenum subTableError(const RasterContext &context, const ImagingCommand &command);

void setColorTable(RasterContext &context, const ImagingCommand &command,
                   const std::vector<imaging::Rgba> &colors);
void setColorSubTable(RasterContext &context, const ImagingCommand &command,
                      const std::vector<imaging::Rgba> &colors);
void setTableParameter(RasterContext &context, const ImagingCommand &command);
void setFilter(RasterContext &context, const ImagingCommand &command,
               const std::vector<imaging::Rgba> &colors);
void setFilterParameter(RasterContext &context, const ImagingCommand &command);
void setHistogram(RasterContext &context, const ImagingCommand &command);
void setMinmax(RasterContext &context, const ImagingCommand &command);
/// Executes ResetHistogram and ResetMinmax.
void resetStatistics(RasterContext &context, GLenum target);

} // namespace arbiter::state
