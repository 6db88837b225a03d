#include "apps/tools/debug/findings.h"

#include <GL/arbiter.h>
#include <algorithm>
#include <limits>

#include "apps/tools/debug/trace/condition.h"
#include "apps/tools/debug/trace/numbers.h"
#include "apps/tools/debug/trace/text.h"
#include "util/text/exit_codes.h"

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

/// True if every color of the results is black, so that equal ones say little about the program.
bool isBlack(const Trace &trace) {
  return std::all_of(trace.results.begin(), trace.results.end(), [](const Named &result) {
    const Vec4 &color = result.value.first;
    return !result.name.starts_with("result.color") ||
           (color[0] == 0 && color[1] == 0 && color[2] == 0);
  });
}

constexpr const char *kBlack = "; it is black, so that little of the program was compared";

std::string verdictText(const Verdict &verdict, const Trace &trace) {
  std::string text = verdictLine(verdict, trace);
  if (verdict.isEqual() && verdict.drawn && isBlack(trace))
    text += kBlack;
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

/// Says where --line stopped; an empty text if it was not given.
std::string lineText(const Findings &findings) {
  if (findings.line == 0 || findings.stopped || findings.trace.rows.empty())
    return {};
  const Row &row = findings.trace.rows[lastRow(findings)];
  const std::string asked = "--line " + std::to_string(findings.line) + ": stopped ";
  if (row.at.line == std::uint32_t(findings.line))
    return asked + atRow(row) + "\n";
  return asked + atRow(row) +
         (row.at.line < std::uint32_t(findings.line) ? ", the last instruction before that line\n"
                                                     : ", the first instruction\n");
}

std::string breakText(const Findings &findings) {
  if (findings.breakOn.empty())
    return {};
  if (!findings.stopped)
    return "--break " + findings.breakOn + ": no instruction\n";
  return "stopped by " + findings.breakOn + " " + atRow(findings.trace.rows[*findings.stopped]) +
         "\n";
}

Json watchJson(const Watched &watch) {
  return {{"value", watch.value},
          {"file", watch.picture.empty() ? Json() : Json(watch.picture)},
          {"pixel", watch.here ? vectorJson(*watch.here) : Json()},
          {"covered", watch.extent.covered},
          {"least", vectorJson(watch.extent.least)},
          {"greatest", vectorJson(watch.extent.greatest)}};
}

Json besideJson(const Trace &trace, const Beside &beside) {
  return {{"file", beside.name},
          {"equal", !beside.first && !beside.result},
          {"result", beside.result ? Json(*beside.result) : Json()},
          {"first", beside.first ? differenceJson(*beside.first, trace, beside.trace) : Json()},
          {"trace", traceJson(beside.trace)}};
}

bool isDifferent(const Findings &findings) {
  if (findings.beside)
    return findings.beside->first || findings.beside->result;
  return findings.verdict ? !findings.verdict->isEqual() : secondDiffers(findings.trace);
}

} // namespace

int exitCodeOf(const Findings &findings) {
  if (findings.stopped)
    return kExitStopped;
  return isDifferent(findings) ? kExitDiffers : kExitOk;
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
  return text + lineText(findings) + breakText(findings) + summaryText(findings) + "\n" +
         (findings.note.empty() ? "" : findings.note + "\n");
}

std::string watchedText(const Findings &findings) {
  const Watched &watch = *findings.watch;
  const auto row = [](const std::string &name, const std::string &value) {
    return "  " + name + std::string(name.size() < 20 ? 20 - name.size() : 1, ' ') + value + "\n";
  };
  const std::string pixel = std::to_string(findings.x) + "," + std::to_string(findings.y);
  std::string text = findings.document + ", " + watch.value + " in the " +
                     std::to_string(watch.extent.covered) + " pixels that are covered of " +
                     std::to_string(findings.width) + "x" + std::to_string(findings.height) + "\n" +
                     row("pixel " + pixel, watch.here ? vectorText(*watch.here) : "not covered");
  if (watch.extent.covered != 0)
    text += row("least", vectorText(watch.extent.least)) +
            row("greatest", vectorText(watch.extent.greatest));
  return text + (findings.note.empty() ? "" : findings.note + "\n") +
         (watch.picture.empty() ? "" : watch.picture + ": " + watch.value + ", written\n");
}

Json findingsJson(const Findings &findings) {
  Json json = traceJson(findings.trace);
  json["schema"] = ARBITER_DEBUG_SCHEMA;
  json["file"] = findings.document;
  json["pixel"] = {findings.x, findings.y};
  json["size"] = {findings.width, findings.height};
  json["pass"] = findings.pass;
  json["frame"] = findings.frame;
  json["stopped"] = findings.stopped ? Json(*findings.stopped) : Json();
  json["verdict"] = findings.verdict ? verdictJson(*findings.verdict, findings.trace) : Json();
  json["against"] = findings.beside ? besideJson(findings.trace, *findings.beside) : Json();
  json["watch"] = findings.watch ? watchJson(*findings.watch) : Json();
  json["note"] = findings.note;
  json["summary"] = summaryText(findings);
  return json;
}

} // namespace arbiter::tools::debug
