#include "apps/tools/advise/show.h"

#include <algorithm>

#include "util/text/letters.h"

namespace arbiter::tools::advise {

namespace {

/// The longest line shown, because a program may be a single line of a megabyte.
constexpr std::size_t kMaxShown = 160;

std::size_t lineBegin(std::string_view text, std::size_t at) {
  while (at > 0 && !endsLine(text[at - 1]))
    --at;
  return at;
}

std::size_t lineEnd(std::string_view text, std::size_t at) {
  while (at < text.size() && !endsLine(text[at]))
    ++at;
  return at;
}

/// Splits text into lines and replaces unprintable characters.
std::vector<std::string> linesOf(std::string_view piece) {
  std::vector<std::string> lines;
  std::string line;
  const auto finish = [&] {
    if (line.find_first_not_of(' ') != std::string::npos)
      lines.push_back(line.size() > kMaxShown ? line.substr(0, kMaxShown - 3) + "..." : line);
    line.clear();
  };
  for (const char c : piece) {
    if (endsLine(c))
      finish();
    else
      line += c == '\t' ? ' ' : c >= ' ' && c <= '~' ? c : '?';
  }
  finish();
  return lines;
}

/// The whole lines of one or more edits that share lines.
struct Block {
  std::size_t begin, end;
  Edits edits;
};

std::vector<Block> blocksOf(std::string_view text, const Edits &edits) {
  std::vector<Block> blocks;
  for (const Edit &edit : edits) {
    const std::size_t begin = lineBegin(text, edit.span.begin);
    // An edit that ends with a line end does not change the next line.
    const bool whole = edit.span.end > edit.span.begin && endsLine(text[edit.span.end - 1]);
    const std::size_t end = whole ? edit.span.end - 1 : lineEnd(text, edit.span.end);
    if (!blocks.empty() && begin <= blocks.back().end) {
      blocks.back().end = std::max(blocks.back().end, end);
      blocks.back().edits.push_back(edit);
    } else {
      blocks.push_back({begin, end, {edit}});
    }
  }
  return blocks;
}

std::string newText(std::string_view text, const Block &block) {
  std::string result;
  std::size_t at = block.begin;
  for (const Edit &edit : block.edits) {
    result += text.substr(at, edit.span.begin - at);
    result += edit.text;
    at = edit.span.end;
  }
  return at < block.end ? result + std::string(text.substr(at, block.end - at)) : result;
}

void writeCost(JsonWriter &json, const char *key, const Cost &cost) {
  json.key(key).beginObject();
  json.key("alu").value(cost.alu).key("tex").value(cost.tex).key("nodes").value(cost.nodes);
  json.key("fits").value(cost.fits).endObject();
}

/// Writes a span as members of the open object.
void writeSpan(JsonWriter &json, std::string_view text, fp::Span span) {
  const fp::LineColumn begin = fp::locate(text, span.begin), end = fp::locate(text, span.end);
  json.key("begin").value(span.begin).key("end").value(span.end);
  json.key("line").value(begin.line).key("column").value(begin.column);
  json.key("end_line").value(end.line).key("end_column").value(end.column);
}

void writeEdits(JsonWriter &json, const char *key, std::string_view text, const Edits &edits) {
  json.key(key).beginArray();
  for (const Edit &edit : edits) {
    json.beginObject();
    writeSpan(json, text, edit.span);
    json.key("text").value(edit.text).endObject();
  }
  json.endArray();
}

} // namespace

std::vector<Change> changesOf(std::string_view text, const Edits &edits) {
  std::vector<Change> changes;
  for (const Block &block : blocksOf(text, edits)) {
    Change change;
    change.line = fp::locate(text, std::uint32_t(block.begin)).line;
    change.old = linesOf(text.substr(block.begin, block.end - block.begin));
    change.now = linesOf(newText(text, block));
    // Remove unchanged lines beside an insertion.
    while (!change.old.empty() && !change.now.empty() && change.old.back() == change.now.back()) {
      change.old.pop_back();
      change.now.pop_back();
    }
    changes.push_back(std::move(change));
  }
  return changes;
}

fp::Diagnostic noteOf(const Advice &advice) {
  return {fp::Severity::Note, advice.rule, advice.span, advice.message, ""};
}

std::string lineText(const std::string &note, const Advice &advice) {
  return note + ": " + changeText(advice.before, advice.after) + "\n";
}

std::string fullText(const std::string &note, std::string_view text, const Advice &advice) {
  std::string result = note + "  " + changeText(advice.before, advice.after);
  if (advice.isFix())
    result += advice.nearness == Nearness::Exact ? "; the same to the bit" : "; but for rounding";
  result += "\n";
  if (!advice.application.empty())
    result += "  if the application " + advice.application + ":\n";
  if (!advice.condition.empty())
    result += "  if " + advice.condition + ":\n";
  for (const Change &change : changesOf(text, advice.isFix() ? advice.edits : advice.sketch)) {
    for (const std::string &line : change.old)
      result += "  - " + line + "\n";
    for (const std::string &line : change.now)
      result += "  + " + line + "\n";
  }
  return result;
}

void writeAdvice(JsonWriter &json, std::string_view text, const std::vector<Advice> &advice) {
  json.beginArray();
  for (const Advice &each : advice) {
    json.beginObject();
    json.key("rule").value(each.rule).key("message").value(each.message);
    writeSpan(json, text, each.span);
    writeCost(json, "before", each.before);
    writeCost(json, "after", each.after);
    json.key("fix").value(each.isFix());
    json.key("exact").value(each.nearness == Nearness::Exact);
    json.key("application").value(each.application).key("condition").value(each.condition);
    writeEdits(json, "edits", text, each.edits);
    writeEdits(json, "sketch", text, each.sketch);
    json.endObject();
  }
  json.endArray();
}

void writeFixed(JsonWriter &json, const Fixed &fixed) {
  json.beginObject();
  json.key("applied").beginArray();
  for (const Advice &each : fixed.applied) {
    json.beginObject().key("rule").value(each.rule).key("message").value(each.message);
    writeCost(json, "before", each.before);
    writeCost(json, "after", each.after);
    json.endObject();
  }
  json.endArray();
  writeCost(json, "before", fixed.before);
  writeCost(json, "after", fixed.after);
  json.key("stopped").value(fixed.stopped);
  json.endObject();
}

} // namespace arbiter::tools::advise
