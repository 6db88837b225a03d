#include "apps/tools/check/compare.h"

#include <array>
#include <cstdio>
#include <vector>

#include "apps/tools/check/json.h"
#include "apps/tools/check/text.h"
#include "apps/tools/check/why.h"
#include "fp_compiler/resources.h"

namespace arbiter::tools {

namespace {

/// One line of the comparison. A side without a model has an empty cell.
struct Line {
  const char *key;
  const char *title;
  std::array<std::optional<double>, 2> api;
  std::array<std::optional<double>, 2> native;
  std::array<std::uint32_t, 2> apiLimits = {};
  std::array<std::uint32_t, 2> nativeLimits = {};
  bool limited = false;
};

using Numbers = std::array<std::optional<double>, 2>;

std::optional<double> delta(const Numbers &numbers) {
  if (!numbers[0] || !numbers[1])
    return std::nullopt;
  return *numbers[1] - *numbers[0];
}

/// A number from the model other than a count; none if the model does not have it.
struct ModelRow {
  const char *key;
  const char *title;
  std::optional<double> (*of)(const CheckedFile &);
};

std::optional<double> when(bool has, double number) {
  return has ? std::optional(number) : std::nullopt;
}

constexpr ModelRow kModelRows[] = {
    {"nodes", "texture nodes",
     [](const CheckedFile &file) {
       return when(!file.native().nodes.empty(), double(file.native().nodes.size()));
     }},
    {"dependent_reads", "dependent reads",
     [](const CheckedFile &file) {
       return when(!file.native().costs.empty(), dependentReads(file));
     }},
    {"cycles", "cycles",
     [](const CheckedFile &file) {
       return when(!file.native().cycles.bound.empty(), file.native().cycles.cycles);
     }},
};

std::vector<Line> linesOf(const Side &a, const Side &b) {
  std::vector<Line> lines;
  for (const fp::ResourceRow &row : fp::resourceRows()) {
    if (!row.of(a.file.language) && !row.of(b.file.language))
      continue;
    Line &line = lines.emplace_back(Line{row.name, row.title, {}, {}});
    line.limited = true;
    const Side *const sides[] = {&a, &b};
    for (std::size_t i = 0; i < 2; ++i) {
      const CheckedFile &file = sides[i]->file;
      if (!row.of(file.language))
        continue;
      line.api[i] = file.result.counts.*row.member;
      if (file.lack().empty())
        line.native[i] = file.result.nativeCounts.*row.member;
      line.apiLimits[i] = file.limits.api.*row.member;
      line.nativeLimits[i] = file.limits.native.*row.member;
    }
  }
  for (const ModelRow &row : kModelRows)
    lines.push_back({row.key, row.title, {}, {row.of(a.file), row.of(b.file)}});
  return lines;
}

/// Returns a cell such as "70/64", aligned right; "-" if there is no number.
std::string cell(const std::optional<double> &used, std::uint32_t limit, bool limited,
                 const Style &style) {
  const std::string text =
      !used ? "-" : decimal(*used) + (limited ? "/" + std::to_string(limit) : "");
  const std::string padding(text.size() < 13 ? 13 - text.size() : 1, ' ');
  const bool over = used && limited && *used > limit;
  return padding + (over ? painted(text, Color::Bad, style) : text);
}

std::string deltaCell(const Numbers &numbers, const Style &style) {
  const std::optional<double> change = delta(numbers);
  std::string text = !change ? "" : decimal(*change);
  if (change && *change > 0)
    text = "+" + text;
  const std::string padding(text.size() < 8 ? 8 - text.size() : 1, ' ');
  if (!change || *change == 0)
    return padding + text;
  return padding + painted(text, *change < 0 ? Color::Good : Color::Close, style);
}

std::string row(const Line &line, const Style &style) {
  char title[32];
  std::snprintf(title, sizeof title, "  %-18s", line.title);
  std::string text = title;
  if (line.limited)
    text += cell(line.api[0], line.apiLimits[0], true, style) +
            cell(line.api[1], line.apiLimits[1], true, style) + deltaCell(line.api, style);
  else
    text += std::string(34, ' ');
  text += cell(line.native[0], line.nativeLimits[0], line.limited, style) +
          cell(line.native[1], line.nativeLimits[1], line.limited, style) +
          deltaCell(line.native, style);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

std::string boundOf(const CheckedFile &file) {
  return file.native().cycles.bound.empty() ? "-" : file.native().cycles.bound;
}

void writeNumber(JsonWriter &json, const std::optional<double> &number) {
  number ? json.value(*number) : json.null();
}

/// Writes {"a": .., "b": .., "delta": ..}.
void writeNumbers(JsonWriter &json, const Numbers &numbers) {
  json.beginObject().key("a");
  writeNumber(json, numbers[0]);
  json.key("b");
  writeNumber(json, numbers[1]);
  json.key("delta");
  writeNumber(json, delta(numbers));
  json.endObject();
}

} // namespace

std::string Comparison::text(const Style &style) const {
  std::string text;
  const Side *const sides[] = {&m_a, &m_b};
  for (const Side *side : sides) {
    const bool named = side->file.counted() || !side->file.hasPrograms(); // by the verdict
    text += briefText(side->file, style);
    text += (side == &m_a ? "A: " : "B: ") + shown(side->file.name) + ": " +
            verdict(side->file, *side->profile) + (named ? "" : " under " + side->profile->name) +
            "\n";
  }
  if (!counted())
    return text;
  char head[160];
  std::snprintf(head, sizeof head, "  %-18s%13s%13s%8s%13s%13s%8s", "resource", "A", "B", "B-A",
                "A native", "B native", "B-A");
  text += painted(head, Color::Dim, style) + "\n";
  for (const Line &line : linesOf(m_a, m_b))
    if (line.limited || line.native[0] || line.native[1])
      text += row(line, style);
  if (boundOf(m_a.file) != "-" || boundOf(m_b.file) != "-") {
    std::snprintf(head, sizeof head, "  %-18s%34s%13s%13s\n", "bound by", "",
                  boundOf(m_a.file).c_str(), boundOf(m_b.file).c_str());
    text += head;
  }
  return text;
}

std::string Comparison::json() const {
  JsonWriter json;
  json.beginObject();
  writeHead(json, *m_a.profile);
  json.key("files").beginArray();
  writeFile(json, m_a.file, m_a.profile);
  writeFile(json, m_b.file, m_b.profile);
  json.endArray();
  json.key("compare");
  if (!counted()) {
    json.null().endObject();
    return json.take();
  }
  json.beginObject();
  json.key("resources").beginObject();
  const std::vector<Line> lines = linesOf(m_a, m_b);
  for (const Line &line : lines) {
    if (!line.limited)
      continue;
    json.key(line.key).beginObject();
    json.key("used");
    writeNumbers(json, line.api);
    json.key("native_used");
    writeNumbers(json, line.native);
    json.endObject();
  }
  json.endObject();
  for (const Line &line : lines) {
    if (line.limited)
      continue;
    json.key(line.key);
    writeNumbers(json, line.native);
  }
  json.endObject().endObject();
  return json.take();
}

} // namespace arbiter::tools
