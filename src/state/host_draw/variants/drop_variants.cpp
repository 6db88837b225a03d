#include "state/host_draw/variants/drop_variants.h"

#include "state/core/context.h"
#include "state/host_draw/linked_program.h"
#include "state/host_draw/variants/array_variants.h"
#include "state/host_draw/variants/ati_variants.h"
#include "state/host_draw/variants/clipped_variant.h"

namespace arbiter::state {

void dropVariants(Context &context, const CompiledProgram &compiled) {
  if (compiled.arrays)
    for (const auto &form : compiled.arrays->all())
      dropVariants(context, *form); // which has no such forms
  context.linkedPrograms->drop(context, &compiled);
  if (compiled.clipped)
    for (const auto &form : compiled.clipped->made())
      context.linkedPrograms->drop(context, form.get());
  if (!compiled.ati)
    return;
  for (const auto &form : compiled.ati->all())
    context.linkedPrograms->drop(context, form.get());
}

} // namespace arbiter::state
