#include "state/host_draw/variants/drop_variants.h"

#include "state/core/context.h"
#include "state/host_draw/linked_program.h"
#include "state/host_draw/variants/array_variants.h"
#include "state/host_draw/variants/ati_variants.h"
#include "state/host_draw/variants/clipped_variant.h"
#include "state/host_draw/variants/depth_variants.h"

namespace arbiter::state {

void dropVariants(Context &context, const CompiledProgram &compiled) {
  context.linkedPrograms->drop(context, &compiled);
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
