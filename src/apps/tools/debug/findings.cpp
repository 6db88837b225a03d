#include "apps/tools/debug/findings.h"

#include <limits>

#include "apps/tools/debug/trace/condition.h"
#include "apps/tools/debug/trace/numbers.h"
#include "apps/tools/debug/trace/text.h"

namespace arbiter::tools::debug {

namespace {

/// True if the two arithmetics differ in 8 bits.
bool secondDiffers(const Trace &trace) {
  for (const Named &result : trace.results)
    if (colorText(result.value.first) != colorText(result.value.second))
      return true;
  return trace.isDiscarded.first != trace.isDiscarded.second;
}

std::string atRow(const Row &row) {
  return "at line " + std::to_string(row.at.line) + ": " + row.text;
}

/// Compares the two arithmetics of one trace.
std::string secondText(const Trace &trace) {
  Condition visible;
  visible.kind = Condition::Kind::Differs;
  const auto first = firstRow(trace, visible);
  std::string text(fp::kNumericsNames[std::size_t(trace.numerics.second)]);
  text += secondDiffers(trace) ? " differs" : ": equal in 8 bits";
  if (first)
    text += ", the first error that 8 bits could show is " + atRow(trace.rows[*first]);
  return text;
}

std::string besideText(const Trace &trace, const Beside &beside) {
  if (!beside.first)
    return beside.name + (beside.result ? " differs in " + *beside.result : ": equal");
  const Difference &first = *beside.first;
  const Row &mine = trace.rows[first.row], &other = beside.trace.rows[first.other];
  std::string text = beside.name + (beside.result ? " differs" : " has the same result") +
                     ", first " + atRow(mine);
  if (mine.text != other.text || mine.at.line != other.at.line)
    text += "\n  there line " + std::to_string(other.at.line) + ": " + other.text;
  if (first.components)
    text += "\n  " + mine.destination + " is " +
            vectorText(first.value.first, first.components, 9) + " here, " +
            vectorText(first.value.second, first.components, 9) + " there";
  else
    text += mine.discards.first ? "\n  the fragment is discarded here and passes there"
                                : "\n  the fragment is discarded there and passes here";
  return text + (first.cause.empty() ? "" : "\n  " + first.cause);
}

std::string verdictText(const Verdict &verdict, const Trace &trace) {
  std::string text = verdictLine(verdict, trace);
  if (verdict.first && verdict.first->components)
    text += "\n  the interpreter has " +
            vectorText(verdict.first->value.first, verdict.first->components, 9) + ", " +
            verdict.drawer + " " +
            vectorText(verdict.first->value.second, verdict.first->components, 9);
  return text;
}

/// Returns the last row to show.
std::size_t lastRow(const Findings &findings) {
  if (findings.stopped)
    return *findings.stopped;
  if (findings.line > 0 && !findings.trace.rows.empty())
    return rowAtLine(findings.trace, std::uint32_t(findings.line));
  return std::numeric_limits<std::size_t>::max();
}

std::string watchText(const Findings &findings) {
  return findings.watch.empty() ? std::string()
                                : findings.picture + ": " + findings.watch + ", written\n";
}

std::string breakText(const Findings &findings) {
  if (findings.breakOn.empty())
    return {};
  if (!findings.stopped)
    return "--break " + findings.breakOn + ": no instruction\n";
  return "stopped by " + findings.breakOn + " " + atRow(findings.trace.rows[*findings.stopped]) +
         "\n";
}

Json besideJson(const Trace &trace, const Beside &beside) {
  return {{"file", beside.name},
          {"equal", !beside.first && !beside.result},
          {"result", beside.result ? Json(*beside.result) : Json()},
          {"first", beside.first ? differenceJson(*beside.first, trace, beside.trace) : Json()},
          {"trace", traceJson(beside.trace)}};
}

} // namespace

bool isDifferent(const Findings &findings) {
  if (findings.stopped)
    return true;
  if (findings.beside)
    return findings.beside->first || findings.beside->result;
  return findings.verdict ? !findings.verdict->isEqual() : secondDiffers(findings.trace);
}

std::string summaryText(const Findings &findings) {
  if (findings.beside)
    return besideText(findings.trace, *findings.beside);
  return findings.verdict ? verdictText(*findings.verdict, findings.trace)
                          : secondText(findings.trace);
}

std::string findingsText(const Findings &findings) {
  TextOptions options;
  options.to = lastRow(findings);
  options.marked = findings.stopped;
  std::string text = findings.document + ", pixel " + std::to_string(findings.x) + "," +
                     std::to_string(findings.y) + " of " + std::to_string(findings.width) + "x" +
                     std::to_string(findings.height) + "\n" + inputsText(findings.trace) + "\n" +
                     rowsText(findings.trace, options) + "\n";
  if (!findings.stopped && findings.line == 0)
    text += resultsText(findings.trace);
  return text + breakText(findings) + summaryText(findings) + "\n" +
         (findings.note.empty() ? "" : findings.note + "\n") + watchText(findings);
}

Json findingsJson(const Findings &findings) {
  Json json = traceJson(findings.trace);
  json["schema"] = kTraceSchema;
  json["file"] = findings.document;
  json["pixel"] = {findings.x, findings.y};
  json["size"] = {findings.width, findings.height};
  json["pass"] = findings.pass;
  json["frame"] = findings.frame;
  json["stopped"] = findings.stopped ? Json(*findings.stopped) : Json();
  json["verdict"] = findings.verdict ? verdictJson(*findings.verdict, findings.trace) : Json();
  json["against"] = findings.beside ? besideJson(findings.trace, *findings.beside) : Json();
  json["watch"] =
      findings.watch.empty() ? Json() : Json{{"value", findings.watch}, {"file", findings.picture}};
  json["note"] = findings.note;
  json["summary"] = summaryText(findings);
  return json;
}

} // namespace arbiter::tools::debug
