#include "apps/tools/lsp/trace.h"

#include "apps/tools/debug/trace/numbers.h"
#include "apps/tools/debug/trace/text.h"
#include "apps/tools/lsp/uri.h"

namespace arbiter::tools::lsp {

namespace {

constexpr int kHintDigits = 4;

std::string hintOf(const debug::Row &row) {
  if (row.mask == 0)
    return row.discards.first ? "discarded" : "passed";
  std::string text = "= " + debug::vectorText(row.value.first, row.mask, kHintDigits);
  for (const debug::FlagName &each : debug::kFlagNames)
    if ((row.flags & each.flag) && each.flag != debug::kOver1 && each.flag != debug::kBelow0)
      text += std::string(" ") + each.name;
  return text;
}

} // namespace

Result<Json, Refusal> Traces::ask(const Document &document, const TraceQuestion &question) {
  Traced &traced = m_traces[document.uri()];
  const TraceQuestion &last = traced.question;
  if (!traced.session || traced.version != document.version || last.pass != question.pass ||
      last.frame != question.frame || last.backend != question.backend ||
      last.profile != question.profile) {
    debug::SessionOptions options;
    const std::string path = pathOf(document.uri());
    options.path = path.empty() ? document.uri() : path;
    options.profile = question.profile;
    options.text = document.text();
    options.pass = question.pass;
    options.frame = question.frame;
    options.backend = question.backend;
    traced = {};
    auto session = debug::Session::open(options);
    if (!session)
      return Refusal{session.error().message};
    traced.session = std::move(session).value();
    traced.version = document.version;
    traced.isOwn = traced.session->fragment().text == document.text();
  }
  traced.question = question;
  auto findings = debug::findingsOf(*traced.session, question.x, question.y);
  if (!findings) {
    const Refusal refusal{findings.error().message};
    traced.findings = {}; // the old findings belong to another pixel
    if (!traced.session->isAlive())
      forget(document.uri());
    return refusal;
  }
  traced.findings = std::move(findings).value();
  traced.findings.pass = question.pass;
  traced.findings.frame = question.frame;
  return debug::findingsJson(traced.findings);
}

const Traces::Traced *Traces::find(const Document &document) const {
  const auto found = m_traces.find(document.uri());
  const bool holds = found != m_traces.end() && found->second.session && found->second.isOwn &&
                     found->second.version == document.version;
  return holds ? &found->second : nullptr;
}

Json Traces::hints(const Document &document, fp::Span span) const {
  Json all = Json::array();
  const Traced *const traced = find(document);
  if (!traced)
    return all;
  const TextMap &map = document.map();
  const std::uint32_t first = map.lineOf(span.begin), last = map.lineOf(span.end);
  for (const debug::Row &row : traced->findings.trace.rows) {
    const std::uint32_t line = map.lineOf(row.span.end);
    if (line >= first && line <= last)
      all.push_back({{"position", map.position(row.span.end)},
                     {"label", hintOf(row)},
                     {"paddingLeft", true}});
  }
  return all;
}

std::string Traces::hover(const Document &document, std::uint32_t offset) const {
  const Traced *const traced = find(document);
  if (!traced)
    return {};
  const auto &rows = traced->findings.trace.rows;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].span.begin <= offset && offset <= rows[i].span.end) {
      debug::TextOptions options;
      options.from = options.to = i;
      return "pixel " + std::to_string(traced->findings.x) + "," +
             std::to_string(traced->findings.y) + "\n\n```\n" +
             debug::rowsText(traced->findings.trace, options) + "```\n";
    }
  return {};
}

} // namespace arbiter::tools::lsp
