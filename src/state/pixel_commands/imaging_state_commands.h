#pragma once
#include <vector>

#include "state/pixel_commands/imaging_commands.h"

/// What commands.h executes, by what it is about. Each raises its errors.
namespace arbiter::state {

/// What is wrong with a command's target, format and size, whatever its colours: nothing is read
/// from the framebuffer for one that is an error.
[[nodiscard]] GLenum tableError(const ImagingCommand &command);
[[nodiscard]] GLenum subTableError(const Context &context, const ImagingCommand &command);

void setColorTable(Context &context, const ImagingCommand &command,
                   const std::vector<imaging::Rgba> &colors);
void setColorSubTable(Context &context, const ImagingCommand &command,
                      const std::vector<imaging::Rgba> &colors);
void setTableParameter(Context &context, const ImagingCommand &command);
void setFilter(Context &context, const ImagingCommand &command,
               const std::vector<imaging::Rgba> &colors);
void setFilterParameter(Context &context, const ImagingCommand &command);
void setHistogram(Context &context, const ImagingCommand &command);
void setMinmax(Context &context, const ImagingCommand &command);
/// ResetHistogram and ResetMinmax.
void resetStatistics(Context &context, GLenum target);

} // namespace arbiter::state
