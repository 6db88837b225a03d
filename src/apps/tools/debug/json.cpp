#include "apps/tools/debug/json.h"

#include <cmath>

#include "apps/tools/debug/trace/numbers.h"
#include "fp_compiler/ir/print.h"
#include "util/numbers/same_bits.h"

namespace arbiter::tools::debug {

namespace {

Json numberJson(float value) {
  return std::isfinite(value) ? Json(value) : Json(numberText(value));
}

/// Adds the member `name`, and "second" if the second value differs.
void addBoth(Json &json, const char *name, const Both<Vec4> &value) {
  json[name] = vectorJson(value.first);
  if (!sameBits(value.first, value.second))
    json["second"] = vectorJson(value.second);
}

Json operandJson(const Operand &operand) {
  Json json = {{"text", operand.text},
               {"begin", operand.span.begin},
               {"end", operand.span.end},
               {"reads", lettersOf(operand.reads)}};
  addBoth(json, "value", operand.value);
  if (operand.unwritten)
    json["unwritten"] = lettersOf(operand.unwritten);
  return json;
}

Json texelJson(const Texel &texel) {
  Json json = {{"unit", texel.unit},
               {"target", fp::ir::targetText(texel.target)},
               {"coordinate", vectorJson(texel.coordinate.first)},
               {"bias", numberJson(texel.bias.first)}};
  addBoth(json, "value", texel.value);
  if (!sameBits(texel.coordinate.first, texel.coordinate.second))
    json["second_coordinate"] = vectorJson(texel.coordinate.second);
  json["lod"] = texel.lod ? numberJson(*texel.lod) : Json();
  return json;
}

Json flagsJson(const Row &row) {
  Json json = Json::array();
  for (const FlagName &each : kFlagNames)
    if (row.flags & each.flag)
      json.push_back(each.name);
  return json;
}

Json rowJson(const Row &row, std::size_t index) {
  Json json = {{"index", index},
               {"line", row.at.line},
               {"column", row.at.column},
               {"begin", row.span.begin},
               {"end", row.span.end},
               {"text", row.text},
               {"opcode", fp::ir::info(row.op).mnemonic},
               {"operands", Json::array()},
               {"flags", flagsJson(row)},
               {"discarded", row.isDiscarded}};
  for (const Operand &operand : row.operands)
    json["operands"].push_back(operandJson(operand));
  if (row.mask == 0) {
    json["discards"] = row.discards.first;
    if (row.discards.first != row.discards.second)
      json["second_discards"] = row.discards.second;
    return json;
  }
  json["destination"] = row.destination;
  json["register"] = row.name;
  json["mask"] = lettersOf(row.mask);
  addBoth(json, "value", row.value);
  json["error"] = numberJson(greatestError(row));
  json["color"] = colorText(row.value.first);
  if (row.texel)
    json["texel"] = texelJson(*row.texel);
  return json;
}

Json namedJson(const std::vector<Named> &all) {
  Json json = Json::array();
  for (const Named &each : all) {
    Json entry = {{"name", each.name}};
    addBoth(entry, "value", each.value);
    if (each.mask != 0xF)
      entry["mask"] = lettersOf(each.mask);
    json.push_back(std::move(entry));
  }
  return json;
}

} // namespace

Json vectorJson(const Vec4 &value) {
  Json json = Json::array();
  for (const float component : value)
    json.push_back(numberJson(component));
  return json;
}

Json traceJson(const Trace &trace) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < trace.rows.size(); ++i)
    rows.push_back(rowJson(trace.rows[i], i));
  return {{"numerics", fp::kNumericsNames[std::size_t(trace.numerics.first)]},
          {"second_numerics", fp::kNumericsNames[std::size_t(trace.numerics.second)]},
          {"attributes", namedJson(trace.attributes)},
          {"parameters", namedJson(trace.parameters)},
          {"rows", std::move(rows)},
          {"results", namedJson(trace.results)},
          {"discarded", trace.isDiscarded.first},
          {"second_discarded", trace.isDiscarded.second}};
}

Json differenceJson(const Difference &difference, const Trace &a, const Trace &b) {
  return {{"row", difference.row},
          {"line", a.rows[difference.row].at.line},
          {"text", a.rows[difference.row].text},
          {"other_row", difference.other},
          {"other_line", b.rows[difference.other].at.line},
          {"other_text", b.rows[difference.other].text},
          {"components", lettersOf(difference.components)},
          {"value", vectorJson(difference.value.first)},
          {"other_value", vectorJson(difference.value.second)},
          {"cause", difference.cause}};
}

Json verdictJson(const Verdict &verdict, const Trace &trace) {
  Json json = {{"drawer", verdict.drawer},
               {"equal", verdict.isEqual()},
               {"bits_equal", verdict.bitsEqual},
               {"picture", hexColor(verdict.picture)},
               {"interpreter", hexColor(verdict.interpreter)},
               {"drawn", verdict.drawn ? vectorJson(*verdict.drawn) : Json()},
               {"hidden", verdict.isHidden},
               {"steps", verdict.steps},
               {"line", verdictLine(verdict, trace)}};
  if (verdict.first)
    json["first"] = differenceJson(*verdict.first, trace, trace);
  return json;
}

} // namespace arbiter::tools::debug
