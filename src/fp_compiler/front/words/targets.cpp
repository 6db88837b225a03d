#include "fp_compiler/front/words/targets.h"

namespace arbiter::fp {

namespace {
constexpr TargetRow kTargetRows[] = {
#define FP_TARGET(word, Enumerator, shadow, doc) {word, ir::TexTarget::Enumerator, shadow},
#include "fp_compiler/front/words/words.def"
};
} // namespace

const TargetRow *findTarget(std::string_view word) {
  for (const TargetRow &row : kTargetRows)
    if (row.word == word)
      return &row;
  return nullptr;
}

std::string_view spelling(ir::TexTarget target) {
  for (const TargetRow &row : kTargetRows)
    if (row.target == target)
      return row.word;
  return {};
}

} // namespace arbiter::fp
