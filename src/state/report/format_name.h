#pragma once
#include <string>

#include <GL/gl.h>

namespace arbiter::state {

/// Returns "RGBA8" and the like for internal formats of the time, else the number.
[[nodiscard]] std::string formatName(GLint format);

} // namespace arbiter::state
