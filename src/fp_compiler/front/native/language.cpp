#include "fp_compiler/front/native/language.h"

#include <algorithm>
#include <iterator>

namespace arbiter::fp::native {

namespace {
using ir::NativeLanguage;

#define NATIVE_LANGUAGE(Enumerator, header, specification, doc)                                    \
  static_assert(ir::headerOf(NativeLanguage::Enumerator) == (header));
#include "fp_compiler/front/native/words.def"

// Sources: NV_fragment_program 3.11.1 and 3.11.3; NV_vertex_program 2.14.1 and 2.14.4;
// NV_vertex_program1_1 2.14.A; NV_vertex_program2 2.14.1.
constexpr Traits kTraits[] = {
    {NativeLanguage::Fp1, 32, 64, 0, false, 0, 0, 0, 0, true, true, false, "RC, HC"},
    {NativeLanguage::Vp1, 12, 0, 1, false, 96, -64, 63, 128, false, false, false, ""},
    {NativeLanguage::Vp11, 12, 0, 1, false, 96, -64, 63, 128, false, true, true, ""},
    {NativeLanguage::Vp2, 16, 0, 2, true, 256, -256, 255, 256, true, true, true, "CC"},
    {NativeLanguage::Vsp1, 12, 0, 1, false, 96, -64, 63, 128, false, false, false, ""},
};
} // namespace

const Traits &traitsOf(NativeLanguage language) {
  return *std::find_if(std::begin(kTraits), std::end(kTraits),
                       [&](const Traits &row) { return row.language == language; });
}

} // namespace arbiter::fp::native
