#include "state/programs/variants/drop_variants.h"

#include "state/core/context_hooks.h"
#include "state/programs/program_context.h"
#include "state/programs/variants/array_variants.h"
#include "state/programs/variants/ati_variants.h"
#include "state/programs/variants/clipped_variant.h"
#include "state/programs/variants/depth_variants.h"

namespace arbiter::state {

void dropVariants(ProgramContext &context, const CompiledProgram &compiled) {
  context.hooks->dropLinkedPrograms(context, compiled);
  const auto dropAll = [&](const auto &variants) {
    if (variants)
      for (const auto &form : variants->all())
        dropVariants(context, *form); // a variant has no variants of the same kind
  };
  dropAll(compiled.arrays);
  dropAll(compiled.clipped);
  dropAll(compiled.ati);
  dropAll(compiled.depths);
}

} // namespace arbiter::state
