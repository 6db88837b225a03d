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
/// Returns the texture target that programs name by `target`.
[[nodiscard]] GLenum glTarget(fp::ir::TexTarget target);

} // namespace arbiter::tools
