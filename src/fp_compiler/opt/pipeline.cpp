#include "fp_compiler/compiler.h"

namespace arbiter::fp {

void optimise(ir::Program &) {}

} // namespace arbiter::fp
