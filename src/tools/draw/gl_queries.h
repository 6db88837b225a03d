#pragma once
#include <epoxy/gl.h>

#include "fp_compiler/ir/ir.h"

namespace arbiter::tools {

[[nodiscard]] int query(GLenum name);
[[nodiscard]] int programLimit(GLenum target, GLenum name);

struct ProgramTarget {
  GLenum name;
  const char *extension;
};
[[nodiscard]] ProgramTarget targetOf(fp::ir::Language language);

} // namespace arbiter::tools
