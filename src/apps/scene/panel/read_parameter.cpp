#include <algorithm>

#include "apps/scene/panel/reader.h"

namespace arbiter::scene {

namespace {

constexpr double kGreatest = 1e30;
constexpr unsigned kMaxAttribs = 16;

/// Reads "[4]" or "[4..6]".
bool readIndex(Reader &reader, Parameter &parameter) {
  const double most = (parameter.space == Setting::Attrib ? kMaxAttribs : kMaxParameters) - 1;
  Number first, last;
  if (!reader.accept(TokenKind::Open))
    return reader.expected("'['", "for example: local[0]");
  if (!reader.integer("an index", 0, most, first))
    return false;
  last = first;
  if (reader.accept(TokenKind::Range) && !reader.integer("the last index", first.value, most, last))
    return false;
  if (!reader.accept(TokenKind::Close))
    return reader.expected("']'");
  parameter.first = unsigned(first.value);
  parameter.count = unsigned(last.value - first.value) + 1;
  return true;
}

/// Reads ".x" or ".xyz": each component once, in order.
bool readMask(Reader &reader, Parameter &parameter) {
  if (!reader.at(TokenKind::Word) || reader.peek().text.front() != '.')
    return true;
  constexpr std::string_view kComponents = "xyzw", kColors = "rgba";
  const std::string_view letters = reader.peek().text.substr(1);
  const std::string_view all =
      letters.find_first_of(kColors) == std::string_view::npos ? kComponents : kColors;
  parameter.mask = {};
  std::size_t next = 0;
  for (const char letter : letters) {
    const std::size_t component = all.find(letter, next);
    if (component == std::string_view::npos)
      return reader.error(reader.peek().span, "panel_syntax", "no components",
                          "of .xyzw or .rgba some, in order");
    parameter.mask[component] = true;
    next = component + 1;
  }
  reader.take();
  return true;
}

bool readNumbers(Reader &reader, Parameter &parameter) {
  const auto most = std::size_t(std::count(parameter.mask.begin(), parameter.mask.end(), true));
  if (parameter.count != 1)
    return reader.expected("rotate or camera, which are rows of a matrix",
                           "several indexes are a matrix; numbers are for one");
  while (parameter.values.size() < most && reader.at(TokenKind::Number))
    if (!reader.number("a value", -kGreatest, kGreatest, parameter.values.emplace_back()))
      return false;
  if (parameter.values.empty())
    return reader.expected("a number", "or rotate, camera or eye");
  return !reader.at(TokenKind::Number) ||
         reader.error(reader.peek().span, "panel_syntax", "more numbers than components",
                      "local[0].xy has two, local[0] four");
}

bool readRotation(Reader &reader, Parameter &parameter) {
  const WordRow &row = rowOf(ValueKind::Rotate);
  Reader::defaults(row, parameter.arguments);
  if (!reader.number("degrees", -36000, 36000, parameter.values.emplace_back()))
    return false;
  for (bool found = true; found;)
    if (!reader.argument(row, parameter.arguments, found))
      return false;
  if (parameter.arguments.get(row, "x") == 0 && parameter.arguments.get(row, "y") == 0 &&
      parameter.arguments.get(row, "z") == 0)
    return reader.error(parameter.kind.span, "panel_syntax", "the rotation has no axis",
                        "for example: rotate 30 z 1");
  return true;
}

bool readValue(Reader &reader, Parameter &parameter) {
  if (!reader.at(TokenKind::Word))
    return readNumbers(reader, parameter);
  if (!reader.word("value", parameter.kind))
    return false;
  if (parameter.kind.value == ValueKind::Eye)
    return true;
  if (parameter.count != 3 && parameter.count != 4)
    return reader.error(parameter.kind.span, "panel_syntax", "a matrix is three or four rows",
                        "for example: env[0..3]");
  return parameter.kind.value == ValueKind::Rotate
             ? readRotation(reader, parameter)
             : reader.name("the name of a target", parameter.target);
}

bool readRange(Reader &reader, Parameter &parameter) {
  parameter.hasRange = true;
  if (!reader.number("the low end", -kGreatest, kGreatest, parameter.low))
    return false;
  if (!reader.accept(TokenKind::Range))
    return reader.expected("'..'", "for example: in 0..1");
  if (!reader.number("the high end", -kGreatest, kGreatest, parameter.high))
    return false;
  return parameter.low.value < parameter.high.value ||
         reader.error(parameter.high.span, "panel_range",
                      "the high end is to be more than the low one");
}

bool readAnimation(Reader &reader, Parameter &parameter) {
  Animation animation;
  if (!reader.word("animation", animation.kind))
    return false;
  if (reader.at(TokenKind::Number) &&
      !reader.number("a period in seconds", 0.001, 86400, animation.period))
    return false;
  const bool turns = animation.kind.value == AnimationKind::Turn;
  if (turns && (parameter.kind.value != ValueKind::Numbers || !parameter.mask[0] ||
                !parameter.mask[2] || parameter.values.size() < 3))
    return reader.error(animation.kind.span, "panel_syntax",
                        "only a value with x, y and z can turn");
  if (parameter.kind.value == ValueKind::Camera || parameter.kind.value == ValueKind::Eye)
    return reader.error(animation.kind.span, "panel_syntax",
                        "what follows from a camera moves with it",
                        "animate a number in its place");
  parameter.animation = animation;
  return true;
}

bool overlap(const Parameter &a, const Parameter &b) {
  if (a.space != b.space || a.first >= b.first + b.count || b.first >= a.first + a.count)
    return false;
  for (int i = 0; i < 4; ++i)
    if (a.mask[std::size_t(i)] && b.mask[std::size_t(i)])
      return true;
  return false;
}

} // namespace

bool readParameter(Reader &reader, Setting space, std::uint32_t begin) {
  Parameter parameter;
  parameter.space = space;
  if (!readIndex(reader, parameter) || !readMask(reader, parameter))
    return false;
  if (reader.at(TokenKind::String) && !reader.name("a label", parameter.label))
    return false;
  if (!reader.accept(TokenKind::Equals))
    return reader.expected("'=' and a value", "for example: local[0].x \"size\" = 0.5 in 0..1");
  if (!readValue(reader, parameter))
    return false;
  for (bool found = true; found;) {
    found = false;
    if (reader.acceptWord("in") && (found = true) && !readRange(reader, parameter))
      return false;
    if (reader.acceptWord("color"))
      parameter.color = found = true;
    if (reader.acceptWord("animate") && (found = true) && !readAnimation(reader, parameter))
      return false;
  }
  parameter.span = {begin, reader.last()};
  for (const Parameter &other : reader.panel().parameters)
    if (overlap(other, parameter))
      return reader.error(parameter.span, "panel_twice", "a component of this has a value already",
                          "one of the two is to go");
  reader.panel().parameters.push_back(std::move(parameter));
  return true;
}

} // namespace arbiter::scene
