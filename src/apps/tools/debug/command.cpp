#include <GL/arbiter.h>
#include <algorithm>
#include <cstdio>
#include <tuple>

#include "apps/scene/picture.h"
#include "apps/tools/commands.h"
#include "apps/tools/debug/findings.h"
#include "apps/tools/debug/pair.h"
#include "apps/tools/debug/session.h"
#include "apps/tools/debug/trace/condition.h"
#include "apps/tools/draw/uses.h"
#include "apps/tools/input.h"
#include "apps/tools/language.h"

namespace arbiter::tools {

namespace {

using debug::Session;
using debug::Trace;

/// Runs the command step by step; a step that fails reports its error.
class Run {
public:
  explicit Run(const DebugArguments &arguments) : m_arguments(arguments) {}

  int run() {
    int code = read();
    if (code == kExitOk && m_arguments.stage == "vertex")
      return vertices();
    if (code == kExitOk && !watchesAlone())
      code = trace();
    if (code == kExitOk && !m_arguments.watch.empty())
      code = watch();
    if (code == kExitOk && !watchesAlone())
      code = compare();
    if (code != kExitOk)
      return code;
    m_findings.note = m_session->end();
    if (watchesAlone()) {
      std::fputs(debug::watchedText(m_findings).c_str(), stdout);
      return kExitOk;
    }
    if (m_arguments.json)
      print(debug::findingsJson(m_findings));
    else
      std::fputs(debug::findingsText(m_findings).c_str(), stdout);
    return debug::exitCodeOf(m_findings);
  }

private:
  static int refuse(const std::string &message, int code = kExitUsage) {
    complain(message);
    return code;
  }

  static void print(const debug::Json &json) {
    std::printf("%s\n", json.dump(1, ' ', false, debug::Json::error_handler_t::replace).c_str());
  }

  static int refuse(const debug::SessionError &error) {
    using Kind = debug::SessionError::Kind;
    if (error.kind == Kind::Invalid) {
      std::fputs(error.message.c_str(), stderr);
      return kExitInvalid;
    }
    return refuse(error.message, error.kind == Kind::NoGl ? kExitNoGl : kExitUsage);
  }

  /// True if the watched values take the place of the trace; the JSON has both.
  bool watchesAlone() const { return !m_arguments.watch.empty() && !m_arguments.json; }

  /// True if --against names a program's file.
  bool isFile() const {
    const std::string &name = m_arguments.against;
    return name != "swrast" && name != "host" && name != "bare" && name != "fp24";
  }

  debug::Backend backend() const {
    if (m_arguments.against == "bare")
      return debug::Backend::Bare;
    return m_arguments.against == "host" ? debug::Backend::Host : debug::Backend::Swrast;
  }

  /// Parses the arguments that need no document.
  int readWords() {
    if (!m_arguments.pixel.empty()) {
      const auto pixel = debug::parsePair<int>(m_arguments.pixel);
      if (!pixel)
        return refuse("--pixel " + m_arguments.pixel + ": expected X,Y");
      std::tie(m_x, m_y) = *pixel;
    }
    const auto range = debug::parsePair<float>(m_arguments.range);
    if (!range || !(range->first < range->second))
      return refuse("--range " + m_arguments.range + ": expected LOW,HIGH");
    std::tie(m_low, m_high) = *range;
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
      const std::string &file = m_arguments.output;
      if (std::string fault = file.empty() ? "" : whyNotWritable(file); !fault.empty())
        return refuse(fault);
    }
    return kExitOk;
  }

  /// Reads the program that --against names.
  int readReference(const fp::hw::Profile &profile) {
    const auto text = readInput(m_arguments.against);
    if (!text)
      return refuse(text.error().message);
    auto checked =
        debug::checkText(m_arguments.against, text.value(), chooseProgram("auto", text.value()),
                         profile, m_session->numerics(), styleOfErrors());
    if (!checked)
      return refuse(checked.error());
    m_reference = std::move(checked).value();
    return kExitOk;
  }

  /// Reads the document's name and text.
  int readDocument(debug::SessionOptions &options) {
    options.path = m_arguments.document;
    if (options.path == "-") {
      auto text = readInput("-");
      if (!text)
        return refuse(text.error().message);
      options.path = "<stdin>";
      options.text = std::move(text).value();
      return kExitOk;
    }
    const auto document = scene::loadDocument(options.path);
    if (!document)
      return refuse(document.error().message);
    options.path = document.value().files.front().name;
    options.text = document.value().files.front().text;
    return kExitOk;
  }

  int read() {
    if (const int code = readWords(); code != kExitOk)
      return code;
    debug::SessionOptions options;
    if (const int code = readDocument(options); code != kExitOk)
      return code;
    options.pass = m_arguments.pass;
    options.frame = m_arguments.frame;
    options.profile = m_arguments.profile;
    options.numerics = m_arguments.numerics;
    options.backend = backend();
    options.textures = m_arguments.textures;
    options.giveTextures = giveTextures;
    options.library = m_arguments.library;
    options.style = styleOfErrors();
    auto session = Session::open(options);
    if (!session)
      return refuse(session.error());
    m_session = std::move(session).value();
    for (const std::string &line : unfedSamples(m_session->document()))
      complain(line);
    describe();
    if (const int code = lookAtLine(); code != kExitOk)
      return code;
    return isFile() ? readReference(m_session->profile()) : int(kExitOk);
  }

  /// Checks that the displayed program has the line of --line.
  int lookAtLine() {
    const debug::CheckedText *const text =
        m_arguments.stage == "vertex" ? m_session->vertex() : &m_session->fragment();
    if (text == nullptr || m_arguments.line == 0)
      return kExitOk;
    const auto ends = std::count(text->text.begin(), text->text.end(), '\n');
    const auto lines = ends + (text->text.ends_with('\n') ? 0 : 1);
    if (m_arguments.line <= lines)
      return kExitOk;
    return refuse("--line " + std::to_string(m_arguments.line) + ": " + text->name + " has " +
                  std::to_string(lines) + (lines == 1 ? " line" : " lines"));
  }

  void describe() {
    const auto [width, height] = m_session->drawer().size();
    if (m_arguments.pixel.empty())
      std::tie(m_x, m_y) = std::tuple(width / 2, height / 2);
    else if (m_arguments.fromTop)
      m_y = height - 1 - m_y;
    m_findings.document = m_session->fragment().name;
    m_findings.x = m_x;
    m_findings.y = m_y;
    m_findings.width = width;
    m_findings.height = height;
    m_findings.pass = m_arguments.pass;
    m_findings.frame = m_arguments.frame;
    m_findings.line = m_arguments.line;
    m_findings.breakOn = m_arguments.breakOn;
  }

  int vertices() {
    const auto triangle = m_session->vertices(m_x, m_y);
    if (!triangle)
      return refuse(triangle.error().message +
                    (m_session->vertex() == nullptr ? std::string() : aboutPixel()));
    debug::Json json = {{"schema", ARBITER_DEBUG_SCHEMA}, {"vertices", debug::Json::array()}};
    bool stopped = false;
    for (const debug::TracedVertex &vertex : triangle.value()) {
      debug::Findings one = m_findings;
      one.document += ", vertex " + std::to_string(vertex.index) + " of the triangle in";
      one.trace = vertex.trace;
      if (m_condition)
        one.stopped = debug::firstRow(one.trace, *m_condition);
      stopped = stopped || one.stopped;
      json["vertices"].push_back(debug::findingsJson(one));
      json["vertices"].back()["vertex"] = vertex.index;
      if (!m_arguments.json)
        std::printf("%s\n", debug::findingsText(one).c_str());
    }
    if (m_arguments.json)
      print(json);
    return stopped ? kExitStopped : kExitOk;
  }

  /// Returns which pixel a complaint is about, if the command line named none.
  std::string aboutPixel() const {
    return m_arguments.pixel.empty() ? " (" + std::to_string(m_x) + "," + std::to_string(m_y) +
                                           ", the middle; --pixel X,Y names another)"
                                     : std::string();
  }

  int trace() {
    auto trace = m_session->trace(m_x, m_y);
    if (!trace)
      return refuse(trace.error().message + aboutPixel());
    m_findings.trace = std::move(trace).value();
    if (m_condition)
      m_findings.stopped = debug::firstRow(m_findings.trace, *m_condition);
    return kExitOk;
  }

  int watch() {
    if (const auto outside = debug::outside(m_session->drawer(), m_x, m_y))
      return refuse(outside->message);
    const auto values = m_session->watch(m_watch);
    if (!values)
      return refuse(values.error().message);
    const auto [width, height] = m_session->drawer().size();
    std::string fault;
    if (!m_arguments.output.empty())
      fault =
          scene::writePng(m_arguments.output,
                          {width, height, debug::picturedValues(values.value(), m_low, m_high)});
    debug::Watched watched{
        m_arguments.watch, m_arguments.output, {}, debug::extentOf(values.value())};
    const auto &here = values.value()[std::size_t(m_y) * std::size_t(width) + std::size_t(m_x)];
    if (here != debug::uncovered())
      watched.here = here;
    m_findings.watch = std::move(watched);
    return fault.empty() ? int(kExitOk) : refuse(fault);
  }

  int compare() {
    if (m_arguments.against == "fp24")
      return kExitOk; // the trace already contains both arithmetics
    const Trace &mine = m_findings.trace;
    if (m_reference) {
      auto trace = m_session->trace(*m_reference, m_x, m_y);
      if (!trace)
        return refuse(m_arguments.against + ": " + trace.error().message);
      const Trace &other = trace.value();
      m_findings.beside = {m_arguments.against, other, debug::firstDifference(mine, other, {}),
                           debug::differingResult(mine, other, {})};
      return kExitOk;
    }
    auto verdict = m_session->verdict(mine, m_x, m_y);
    if (!verdict)
      return refuse(verdict.error().message, kExitNoGl);
    m_findings.verdict = std::move(verdict).value();
    return kExitOk;
  }

  const DebugArguments &m_arguments;
  int m_x = 0, m_y = 0;
  float m_low = 0, m_high = 1;
  std::optional<debug::Condition> m_condition;
  debug::Watch m_watch;
  std::optional<debug::CheckedText> m_reference;
  std::unique_ptr<Session> m_session;
  debug::Findings m_findings;
};

} // namespace

int debugPixel(const DebugArguments &arguments) { return Run(arguments).run(); }

} // namespace arbiter::tools
