#include "fp_compiler/front/nvparse/words.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "fp_compiler/front/words/numeral.h"

namespace arbiter::fp::nvparse {

namespace {
using combiners::Register;

struct RegisterRow {
  Register first;
  std::string_view word;
  int count;
};
constexpr RegisterRow kRegisters[] = {
#define RC_REGISTER(Enumerator, word, count, doc) {Register::Enumerator, word, count},
#include "fp_compiler/front/nvparse/words.def"
};

constexpr OperationWord kOperations[] = {
#define TS_OPERATION(word, Enumerator, stage, stages, arguments, extension, doc)                   \
  {word, texture_shader::Operation::Enumerator, stage, stages, Arguments::arguments, extension,    \
   doc},
#include "fp_compiler/front/nvparse/words.def"
};
} // namespace

std::optional<NamedRegister> registerOf(std::string_view word) {
  if (word == "one")
    return NamedRegister{Register::Zero, true};
  for (const RegisterRow &row : kRegisters) {
    if (row.count == 0 && word == row.word)
      return NamedRegister{row.first, false};
    if (const auto number = numberBehind(word, row.word); number && int(*number) < row.count)
      return NamedRegister{Register(int(row.first) + int(*number)), false};
  }
  return std::nullopt;
}

std::string wordOf(Register name) {
  for (const RegisterRow &row : kRegisters)
    if (const int number = int(name) - int(row.first);
        number >= 0 && number < std::max(row.count, 1))
      return std::string(row.word) + (row.count == 0 ? std::string() : std::to_string(number));
  return {};
}

std::vector<std::string_view> registerWords() {
  return {"zero",   "one",  "const0", "const1", "fog",  "col0",    "col1",          "spare0",
          "spare1", "tex0", "tex1",   "tex2",   "tex3", "discard", "final_product", "color_sum"};
}

std::span<const OperationWord> operationWords() { return kOperations; }

const OperationWord *operationOf(std::string_view word) {
  const auto *const found =
      std::find_if(std::begin(kOperations), std::end(kOperations),
                   [&](const OperationWord &row) { return row.word == word; });
  return found == std::end(kOperations) ? nullptr : found;
}

} // namespace arbiter::fp::nvparse
