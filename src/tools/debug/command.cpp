#include <charconv>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "tools/commands.h"
#include "tools/debug/condition.h"
#include "tools/debug/json.h"
#include "tools/debug/numbers.h"
#include "tools/debug/session.h"
#include "tools/debug/text.h"
#include "tools/input.h"
#include "tools/picture.h"

namespace arbiter::tools {

namespace {

using debug::DebugError;
using debug::Json;
using debug::Session;
using debug::Trace;

template <typename Number>
bool readPair(std::string_view text, Number &first, Number &second) {
  const char *const end = text.data() + text.size();
  const auto mark = std::from_chars(text.data(), end, first);
  if (mark.ec != std::errc() || mark.ptr == end || *mark.ptr != ',')
    return false;
  const auto last = std::from_chars(mark.ptr + 1, end, second);
  return last.ec == std::errc() && last.ptr == end;
}

/// Another program beside the document's, and where the two part.
struct Beside {
  debug::CheckedText program;
  Trace trace;
  std::optional<debug::Difference> first;
  std::optional<std::string> result;
};

/// One run of the command, step by step; the first step that fails has said why.
class Run {
public:
  explicit Run(const DebugArguments &arguments) : m_arguments(arguments) {}

  int run() {
    int code = read();
    if (code == kExitOk)
      code = trace();
    if (code == kExitOk && !m_arguments.watch.empty())
      code = watch();
    if (code == kExitOk)
      code = compare();
    if (code != kExitOk)
      return code;
    if (m_arguments.json)
      printJson();
    else
      printText();
    return differs() ? kExitDiffers : kExitOk;
  }

private:
  static int refuse(const std::string &message, int code = kExitUsage) {
    complain(message);
    return code;
  }

  static int refuse(const debug::SessionError &error) {
    using Kind = debug::SessionError::Kind;
    if (error.kind == Kind::Invalid) {
      std::fputs(error.message.c_str(), stderr);
      return kExitInvalid;
    }
    return refuse(error.message, error.kind == Kind::NoGl ? kExitInternal : kExitUsage);
  }

  /// Whether --against names a program.
  bool isFile() const {
    const std::string &name = m_arguments.against;
    return name != "swrast" && name != "host" && name != "bare" && name != "fp24";
  }

  debug::Backend backend() const {
    if (m_arguments.against == "bare")
      return debug::Backend::Bare;
    const bool fp24 = m_arguments.numerics == "fp24"; // which the rasterizer has no code for
    return m_arguments.against == "host" || fp24 ? debug::Backend::Host : debug::Backend::Swrast;
  }

  /// The words that need no document.
  int readWords() {
    if (!readPair(m_arguments.pixel, m_x, m_y))
      return refuse("--pixel " + m_arguments.pixel + ": expected X,Y");
    if (!readPair(m_arguments.range, m_low, m_high) || !(m_low < m_high))
      return refuse("--range " + m_arguments.range + ": expected LOW,HIGH");
    if (!m_arguments.breakOn.empty()) {
      auto condition = debug::parseCondition(m_arguments.breakOn);
      if (!condition)
        return refuse(condition.error().message);
      m_condition = condition.value();
    }
    if (!m_arguments.watch.empty()) {
      auto watch = debug::parseWatch(m_arguments.watch);
      if (!watch)
        return refuse(watch.error().message);
      m_watch = watch.value();
      if (std::string fault = whyNotWritable(m_arguments.output); !fault.empty())
        return refuse(fault);
    }
    if (m_arguments.numerics == "fp24" && m_arguments.against == "bare")
      return refuse("--against bare: the host's own implementation has no fp24 arithmetic");
    return kExitOk;
  }

  int read() {
    if (const int code = readWords(); code != kExitOk)
      return code;
    const auto profile = fp::hw::loadProfile(m_arguments.profile);
    if (!profile)
      return refuse(profile.error().message);
    if (isFile()) {
      const auto text = readInput(m_arguments.against);
      if (!text)
        return refuse(text.error().message + " (--against takes swrast, host, bare, fp24, or a "
                                             "program's file)");
      auto checked = debug::checkText(m_arguments.against, text.value(), profile.value());
      if (!checked)
        return refuse(checked.error());
      m_beside.emplace().program = std::move(checked).value();
    }
    const auto text = readInput(m_arguments.document);
    if (!text)
      return refuse(text.error().message);
    debug::SessionOptions options;
    options.path = m_arguments.document;
    options.text = text.value();
    options.pass = m_arguments.pass;
    options.frame = m_arguments.frame;
    options.profile = profile.value();
    options.numerics = m_arguments.numerics;
    options.backend = backend();
    options.library = m_arguments.library;
    auto session = Session::open(options);
    if (!session)
      return refuse(session.error());
    m_session = std::move(session).value();
    if (m_arguments.fromTop)
      m_y = m_session->drawer().size()[1] - 1 - m_y;
    return kExitOk;
  }

  int trace() {
    auto trace = m_session->trace(m_x, m_y);
    if (!trace)
      return refuse(trace.error().message);
    m_trace = std::move(trace).value();
    if (m_condition)
      m_stopped = debug::firstRow(m_trace, *m_condition);
    return kExitOk;
  }

  int watch() {
    const auto values = m_session->watch(m_watch);
    if (!values)
      return refuse(values.error().message);
    const auto [width, height] = m_session->drawer().size();
    const std::string fault =
        writePng(m_arguments.output,
                 {width, height, debug::picturedValues(values.value(), m_low, m_high)});
    return fault.empty() ? int(kExitOk) : refuse(fault);
  }

  int compare() {
    if (m_arguments.against == "fp24")
      return kExitOk; // both arithmetics are in the trace
    if (m_beside) {
      auto trace = m_session->trace(m_beside->program, m_x, m_y);
      if (!trace)
        return refuse(m_arguments.against + ": " + trace.error().message);
      m_beside->trace = std::move(trace).value();
      m_beside->first = debug::firstDifference(m_trace, m_beside->trace, {});
      m_beside->result = debug::differingResult(m_trace, m_beside->trace, {});
      return kExitOk;
    }
    auto verdict = m_session->verdict(m_trace, m_x, m_y);
    if (!verdict)
      return refuse(verdict.error().message, kExitInternal);
    m_verdict = std::move(verdict).value();
    return kExitOk;
  }

  bool differs() const {
    if (m_stopped)
      return true;
    if (m_beside)
      return m_beside->first || m_beside->result;
    return m_verdict ? !m_verdict->isEqual() : secondDiffers();
  }

  /// Whether 8 bits show the second arithmetic.
  bool secondDiffers() const {
    for (const debug::Named &result : m_trace.results)
      if (debug::colorText(result.value.first) != debug::colorText(result.value.second))
        return true;
    return m_trace.isDiscarded.first != m_trace.isDiscarded.second;
  }

  /// The first row whose second value 8 bits could show.
  std::optional<std::size_t> firstVisible() const {
    debug::Condition condition;
    condition.kind = debug::Condition::Kind::Differs;
    return debug::firstRow(m_trace, condition);
  }

  std::string secondLine() const {
    const std::string name(fp::kNumericsNames[std::size_t(m_trace.numerics.second)]);
    const auto first = firstVisible();
    if (!secondDiffers() && !first)
      return name + ": equal in 8 bits";
    std::string line = name + (secondDiffers() ? " differs" : ": equal in 8 bits");
    if (first)
      line += ", the first error that 8 bits could show is at line " +
              std::to_string(m_trace.rows[*first].at.line) + ": " + m_trace.rows[*first].text;
    return line;
  }

  std::string besideLine() const {
    const std::string &name = m_arguments.against;
    if (!m_beside->first)
      return m_beside->result ? name + " differs in " + *m_beside->result : name + ": equal";
    const debug::Difference &first = *m_beside->first;
    const debug::Row &mine = m_trace.rows[first.row];
    const debug::Row &other = m_beside->trace.rows[first.other];
    std::string text = name + (m_beside->result ? " differs" : " has the same result") +
                       ", first at line " + std::to_string(mine.at.line) + ": " + mine.text;
    if (mine.text != other.text || mine.at.line != other.at.line)
      text += "\n  there line " + std::to_string(other.at.line) + ": " + other.text;
    if (first.components)
      text += "\n  " + mine.destination + " is " +
              debug::vectorText(first.value.first, first.components, 9) + " here, " +
              debug::vectorText(first.value.second, first.components, 9) + " there";
    else
      text += std::string("\n  the fragment is ") +
              (mine.discards.first ? "discarded here, and passes there" : "discarded there alone");
    return text + (first.cause.empty() ? "" : "\n  " + first.cause);
  }

  std::string verdictText() const {
    if (m_beside)
      return besideLine();
    if (!m_verdict)
      return secondLine();
    std::string text = debug::verdictLine(*m_verdict, m_trace);
    if (m_verdict->first && m_verdict->first->components)
      text += "\n  the interpreter has " +
              debug::vectorText(m_verdict->first->value.first, m_verdict->first->components, 9) +
              ", " + m_verdict->drawer + " " +
              debug::vectorText(m_verdict->first->value.second, m_verdict->first->components, 9);
    return text;
  }

  /// The last row to show.
  std::size_t lastRow() const {
    if (m_stopped)
      return *m_stopped;
    if (m_arguments.line > 0 && !m_trace.rows.empty())
      return debug::rowAtLine(m_trace, std::uint32_t(m_arguments.line));
    return std::numeric_limits<std::size_t>::max();
  }

  void printText() const {
    const auto [width, height] = m_session->drawer().size();
    std::string text = m_arguments.document + ", pixel " + std::to_string(m_x) + "," +
                       std::to_string(m_y) + " of " + std::to_string(width) + "x" +
                       std::to_string(height) + "\n" + debug::inputsText(m_trace) + "\n";
    debug::TextOptions options;
    options.to = lastRow();
    options.marked = m_stopped;
    text += debug::rowsText(m_trace, options) + "\n";
    if (!m_stopped && m_arguments.line == 0)
      text += debug::resultsText(m_trace);
    if (m_condition)
      text += m_stopped ? "stopped: " + m_arguments.breakOn + " at line " +
                              std::to_string(m_trace.rows[*m_stopped].at.line) + "\n"
                        : "--break " + m_arguments.breakOn + ": no instruction\n";
    text += verdictText() + "\n";
    std::fputs(text.c_str(), stdout);
  }

  Json besideJson() const {
    Json json = {{"file", m_arguments.against},
                 {"equal", !m_beside->first && !m_beside->result},
                 {"line", besideLine()},
                 {"trace", debug::traceJson(m_beside->trace)}};
    json["result"] = m_beside->result ? Json(*m_beside->result) : Json();
    json["first"] = m_beside->first
                        ? debug::differenceJson(*m_beside->first, m_trace, m_beside->trace)
                        : Json();
    return json;
  }

  void printJson() const {
    const auto [width, height] = m_session->drawer().size();
    Json json = debug::traceJson(m_trace);
    json["schema"] = debug::kTraceSchema;
    json["file"] = m_arguments.document;
    json["pixel"] = {m_x, m_y};
    json["size"] = {width, height};
    json["pass"] = m_arguments.pass;
    json["frame"] = m_arguments.frame;
    json["stopped"] = m_stopped ? Json(*m_stopped) : Json();
    json["verdict"] = m_verdict ? debug::verdictJson(*m_verdict, m_trace) : Json();
    json["against"] = m_beside ? besideJson() : Json();
    json["summary"] = verdictText();
    std::printf("%s\n", json.dump(1, ' ', false, Json::error_handler_t::replace).c_str());
  }

  const DebugArguments &m_arguments;
  int m_x = 0, m_y = 0;
  float m_low = 0, m_high = 1;
  std::optional<debug::Condition> m_condition;
  debug::Watch m_watch;
  std::unique_ptr<Session> m_session;
  Trace m_trace;
  std::optional<std::size_t> m_stopped;
  std::optional<debug::Verdict> m_verdict;
  std::optional<Beside> m_beside;
};

} // namespace

int debug(const DebugArguments &arguments) { return Run(arguments).run(); }

} // namespace arbiter::tools
