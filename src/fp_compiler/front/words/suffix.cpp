#include "fp_compiler/front/words/suffix.h"

namespace arbiter::fp {

namespace {

constexpr std::string_view kXyzw = "xyzw";
constexpr std::string_view kRgba = "rgba";

/// Returns 0 to 3, or npos. Sets `set` to the first letter of the component's set.
std::size_t component(char letter, bool colors, char &set) {
  std::size_t index = kXyzw.find(letter);
  set = 'x';
  if (index == std::string_view::npos && colors) {
    index = kRgba.find(letter);
    set = 'r';
  }
  return index;
}

/// Reads the component of a letter. It is an error if the letter is none, or of another set than
/// `set` (0: any).
SuffixError readComponent(std::string_view word, std::uint32_t at, bool colors, char &set,
                          std::size_t &index) {
  char own = 0;
  index = component(word[at], colors, own);
  if (index == std::string_view::npos)
    return {"no such component", at};
  if (set != 0 && set != own)
    return {"xyzw and rgba do not mix", at};
  set = own;
  return {};
}

} // namespace

SuffixError readSwizzle(std::string_view word, bool colors, bool scalar, ir::Swizzle &swizzle) {
  const std::uint32_t most = scalar ? 1 : 4;
  char set = 0;
  ir::Swizzle read = ir::kIdentity;
  for (std::uint32_t i = 0; i < word.size(); ++i) {
    if (i == most)
      return {scalar ? "more than one component" : "more than four components", i};
    std::size_t index = 0;
    if (const SuffixError wrong = readComponent(word, i, colors, set, index))
      return wrong;
    read[i] = ir::Select(index);
  }
  if (word.size() != 1 && word.size() != 4)
    return {"two or three components", 0};
  if (word.size() == 1)
    read.fill(read[0]);
  swizzle = read;
  return {};
}

SuffixError readMask(std::string_view word, bool colors, std::uint8_t &mask) {
  char set = 0;
  std::uint8_t read = 0;
  for (std::uint32_t i = 0; i < word.size(); ++i) {
    std::size_t index = 0;
    if (const SuffixError wrong = readComponent(word, i, colors, set, index))
      return wrong;
    // No bit from this component on may be set yet.
    if (read >> index != 0)
      return {"a component out of order", i};
    read |= std::uint8_t(1u << index);
  }
  mask = read;
  return {};
}

SuffixError readSelector(std::string_view word, bool colors, char &set, ir::Select &select) {
  if (word == "0" || word == "1") {
    select = word == "0" ? ir::Select::Zero : ir::Select::One;
    return {};
  }
  std::size_t index = 0;
  if (const SuffixError wrong = readComponent(word, 0, colors, set, index))
    return wrong;
  if (word.size() > 1)
    return {"more than one component", 1};
  select = ir::Select(index);
  return {};
}

} // namespace arbiter::fp
