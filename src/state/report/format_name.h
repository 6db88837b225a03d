#pragma once
#include <string>

#include <GL/gl.h>

namespace arbiter::state {

/// "RGBA8" for the internal formats of the time, else the number.
[[nodiscard]] std::string formatName(GLint format);

} // namespace arbiter::state
