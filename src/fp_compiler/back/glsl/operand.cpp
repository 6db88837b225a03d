#include <algorithm>

#include "fp_compiler/back/glsl/expression.h"

namespace arbiter::fp::glsl {

using ir::Operand;
using ir::Select;

namespace {
constexpr const char *kLetters = "xyzw";

Select selectOf(const Operand &operand, int position) {
  return operand.swizzle[std::size_t(position)];
}

bool negated(const Operand &operand, int position) { return operand.negate >> position & 1; }

/// True if a swizzled variable can express the components: no 0 or 1, and one common sign.
bool isPlainSwizzle(const Operand &operand, const Components &components) {
  return std::all_of(components.begin(), components.end(), [&](int position) {
    return selectOf(operand, position) <= Select::W &&
           negated(operand, position) == negated(operand, components.front());
  });
}
} // namespace

Components positions(std::uint8_t mask) {
  Components result;
  for (int i = 0; i < 4; ++i)
    if (mask >> i & 1)
      result.push_back(i);
  return result;
}

std::string suffix(const Components &components) {
  if (components == Components{0, 1, 2, 3})
    return "";
  std::string text = ".";
  for (const int position : components)
    text += kLetters[position];
  return text;
}

std::string typeName(std::size_t width) {
  return width == 1 ? "float" : "vec" + std::to_string(width);
}

std::string component(const Registers &registers, const Operand &operand, int position) {
  const Select select = selectOf(operand, position);
  const std::string sign = negated(operand, position) ? "-" : "";
  if (select == Select::Zero)
    return sign + "0.0";
  if (select == Select::One)
    return sign + "1.0";
  const std::string &text =
      registers.source(operand.file, operand.index).components[std::size_t(select)];
  // "--1.0" would be a decrement.
  if (!sign.empty() && text[0] == '-')
    return text.substr(1);
  return sign + text;
}

std::string compose(const std::vector<std::string> &parts) {
  if (parts.size() == 1)
    return parts.front();
  std::string text = typeName(parts.size()) + "(" + parts.front();
  if (!std::all_of(parts.begin(), parts.end(), [&](auto &part) { return part == parts.front(); }))
    for (std::size_t i = 1; i < parts.size(); ++i)
      text += ", " + parts[i];
  return text + ")";
}

std::string vector(const Registers &registers, const Operand &operand,
                   const Components &components) {
  if (components.size() > 1 && isPlainSwizzle(operand, components)) {
    const std::string &name = registers.source(operand.file, operand.index).variable;
    if (!name.empty()) {
      Components selected;
      for (const int position : components)
        selected.push_back(int(selectOf(operand, position)));
      return (negated(operand, components.front()) ? "-" : "") + name + suffix(selected);
    }
  }
  std::vector<std::string> parts;
  for (const int position : components)
    parts.push_back(component(registers, operand, position));
  return compose(parts);
}

} // namespace arbiter::fp::glsl
