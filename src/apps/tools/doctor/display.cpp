#include <cstdlib>

#include "apps/tools/doctor/finding.h"
#include "apps/tools/launch/shell_text.h"

namespace arbiter::tools::doctor {

void examineDisplay(Examination &examination, const std::vector<std::string> &command) {
  for (const char *const name : {"DISPLAY", "WAYLAND_DISPLAY"})
    if (const char *const value = std::getenv(name); value != nullptr && *value != '\0')
      return;
  if (examination.has("no_gl") || examination.has("static"))
    return; // it opens no window of GL, or not by the layer
  examination.add(
      {kNoDisplay,
       Level::Possible,
       {},
       "Neither DISPLAY nor WAYLAND_DISPLAY is set: a program that opens a window ends at once.",
       "Start it in a terminal of the desktop. Without a screen (packages xvfb and xauth): "
       "`xvfb-run -a -s -noreset arbiter run -- " +
           shellLine(command) + "`."});
}

} // namespace arbiter::tools::doctor
