#include "apps/tools/debug/trace/condition.h"

#include <charconv>
#include <utility>

namespace arbiter::tools::debug {

namespace {

using Relation = Condition::Relation;

// Longer relations come first, because "<=" begins with "<".
constexpr std::pair<std::string_view, Relation> kRelations[] = {
    {"<=", Relation::LessEqual}, {">=", Relation::GreaterEqual}, {"!=", Relation::Unequal},
    {"<", Relation::Less},       {">", Relation::Greater},       {"=", Relation::Equal}};

DebugError unknown(std::string_view text) {
  std::string words;
  for (const FlagName &each : kFlagNames)
    words += std::string(each.name) + ", ";
  return {"--break " + std::string(text) + ": expected " + words +
          "kil, differs, or a comparison as in 'offset.x>0.5'"};
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ')
    text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ')
    text.remove_suffix(1);
  return text;
}

/// Reads "offset.x" into the condition's register and component.
bool readComponent(std::string_view text, Condition &condition) {
  const std::size_t dot = text.rfind('.');
  if (dot == std::string_view::npos || dot == 0 || dot + 2 != text.size())
    return false;
  constexpr std::string_view kXyzw = "xyzw", kRgba = "rgba";
  std::size_t component = kXyzw.find(text[dot + 1]);
  if (component == std::string_view::npos)
    component = kRgba.find(text[dot + 1]);
  if (component == std::string_view::npos)
    return false;
  condition.reg = text.substr(0, dot);
  condition.component = unsigned(component);
  return true;
}

bool compares(Relation relation, float value, float bound) {
  switch (relation) {
  case Relation::Less:
    return value < bound;
  case Relation::Greater:
    return value > bound;
  case Relation::LessEqual:
    return value <= bound;
  case Relation::GreaterEqual:
    return value >= bound;
  case Relation::Equal:
    return value == bound;
  case Relation::Unequal:
    break;
  }
  return value != bound;
}

} // namespace

std::string_view registerName(std::string_view destination) {
  const std::size_t dot = destination.rfind('.');
  if (dot == std::string_view::npos)
    return destination;
  const std::string_view last = destination.substr(dot + 1);
  const bool isMask = !last.empty() && last.size() <= 4 &&
                      (last.find_first_not_of("xyzw") == std::string_view::npos ||
                       last.find_first_not_of("rgba") == std::string_view::npos);
  return isMask ? destination.substr(0, dot) : destination;
}

Result<Condition, DebugError> parseCondition(std::string_view text) {
  Condition condition;
  for (const FlagName &each : kFlagNames)
    if (text == each.name) {
      condition.flag = each.flag;
      return condition;
    }
  if (text == "kil" || text == "differs") {
    condition.kind = text == "kil" ? Condition::Kind::Kil : Condition::Kind::Differs;
    return condition;
  }
  condition.kind = Condition::Kind::Compare;
  for (const auto &[sign, relation] : kRelations) {
    const std::size_t at = text.find(sign);
    if (at == std::string_view::npos)
      continue;
    const std::string_view number = trimmed(text.substr(at + sign.size()));
    const auto end = std::from_chars(number.data(), number.data() + number.size(), condition.bound);
    if (end.ec != std::errc() || end.ptr != number.data() + number.size() ||
        !readComponent(trimmed(text.substr(0, at)), condition))
      return unknown(text);
    condition.relation = relation;
    return condition;
  }
  return unknown(text);
}

bool holds(const Condition &condition, const Row &row) {
  switch (condition.kind) {
  case Condition::Kind::Flag:
    return (row.flags & condition.flag) != 0;
  case Condition::Kind::Kil:
    return row.discards.first;
  case Condition::Kind::Differs:
    return greatestError(row) > kVisible || row.discards.first != row.discards.second;
  case Condition::Kind::Compare:
    break;
  }
  return (row.mask >> condition.component & 1) && registerName(row.destination) == condition.reg &&
         compares(condition.relation, row.value.first[condition.component], condition.bound);
}

std::optional<std::size_t> firstRow(const Trace &trace, const Condition &condition,
                                    std::size_t from) {
  for (std::size_t i = from; i < trace.rows.size(); ++i)
    if (holds(condition, trace.rows[i]))
      return i;
  return {};
}

} // namespace arbiter::tools::debug
