#include "nv_texts.h"

namespace bench {
namespace {

void replaceAll(std::string &text, std::string_view what, const std::string &with) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

} // namespace

std::string nvText(const NvPair &pair, bool nv, unsigned seed) {
  std::string text(nv ? pair.nv : pair.arb);
  if (pair.target == GL_FRAGMENT_PROGRAM_ARB) {
    replaceAll(text, "@", "0.5" + std::to_string(1000 + seed % 9000));
    return text;
  }
  constexpr std::string_view kLetters = "xyzw";
  const std::string index = std::to_string(seed % 96);
  replaceAll(text, "@];", index + "]." + kLetters[seed / 96 % 4] + ";");
  return text;
}

} // namespace bench
