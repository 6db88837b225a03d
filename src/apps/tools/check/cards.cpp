#include "apps/tools/check/cards.h"

#include <algorithm>

#include <GL/arbiter.h>

#include "apps/tools/check/source_text.h"
#include "apps/tools/commands.h"
#include "apps/tools/input.h"
#include "apps/tools/language.h"
#include "fp_compiler/hw/native.h"
#include "fp_compiler/resources.h"
#include "util/json.h"

namespace arbiter::tools {

namespace {

std::string firstError(const fp::CheckResult &result, const std::string &text) {
  for (const fp::Diagnostic &diagnostic : result.diagnostics) {
    if (diagnostic.severity != fp::Severity::Error)
      continue;
    const fp::LineColumn at = fp::locate(text, diagnostic.span.begin);
    return std::to_string(at.line) + ":" + std::to_string(at.column) + ": " + diagnostic.message;
  }
  return {};
}

CardCell cellOf(const std::string &text, const fp::FileProgram &program, fp::LimitPolicy policy,
                const fp::hw::Profile &card) {
  const fp::ir::Language language = program.language;
  const fp::Limits limits = limitsOf(card, language);
  const fp::CheckResult result = fp::checkProgramIn(text, program, {limits, policy});
  CardCell cell;
  const std::string_view lack = lackOf(limits, language);
  cell.hasLanguage = hasPrograms(limits, language);
  cell.runsItself = lack.empty();
  if (!result.ok()) {
    cell.status = FileStatus::Invalid;
    cell.why = cell.hasLanguage ? firstError(result, text) : std::string(lack);
    return cell;
  }
  if (result.underNativeLimits)
    return cell;
  cell.status = FileStatus::OverNative;
  for (const fp::ResourceRow &row : fp::resourceRows())
    if (row.of(language) && result.nativeCounts.*row.member > limits.native.*row.member)
      cell.over.push_back({&row, result.nativeCounts.*row.member, limits.native.*row.member});
  cell.why = lack;
  if (!lack.empty())
    return cell;
  const auto report = fp::hw::explainNative(*result.program, result.counts, limits, text);
  // A reason without instructions holds for every program.
  const auto isOver = [&cell](const fp::hw::Reason &reason) {
    return !reason.instructions.empty() &&
           std::any_of(cell.over.begin(), cell.over.end(), [&reason](const OverCount &over) {
             return over.row->member == reason.resource;
           });
  };
  const auto found = std::find_if(report.reasons.begin(), report.reasons.end(), isOver);
  if (found != report.reasons.end())
    cell.why = found->text;
  return cell;
}

bool loads(const CardCell &cell) {
  return cell.status == FileStatus::OverNative && cell.hasLanguage;
}

const char *word(const CardCell &cell) {
  return cell.status == FileStatus::Valid ? "fits" : loads(cell) ? "over" : "no";
}

Colour colourOf(const CardCell &cell) {
  return cell.status == FileStatus::Valid ? Colour::Good
         : loads(cell)                    ? Colour::Close
                                          : Colour::Bad;
}

std::string padded(const std::string &text, std::size_t width) {
  return text + std::string(width > text.size() ? width - text.size() : 0, ' ');
}

std::string reasonOf(const CardCell &cell) {
  if (!cell.hasLanguage)
    return cell.why;
  if (cell.status == FileStatus::Invalid)
    return "not valid: " + cell.why;
  if (!cell.runsItself)
    return cell.why;
  std::string text = "over the native limits";
  const char *between = ": ";
  for (const OverCount &over : cell.over) {
    text += between + std::string(over.row->title) + " " + std::to_string(over.used) + " of " +
            std::to_string(over.limit);
    between = ", ";
  }
  return cell.why.empty() ? text : text + " (" + cell.why + ")";
}

void writeCell(JsonWriter &json, const fp::hw::Profile &card, const CardCell &cell) {
  json.beginObject().key("profile").value(card.name).key("status").value(name(cell.status));
  json.key("over").beginArray();
  for (const OverCount &over : cell.over) {
    json.beginObject().key("resource").value(over.row->name);
    json.key("native_used").value(over.used).key("native_limit").value(over.limit).endObject();
  }
  json.endArray().key("why").value(cell.why).endObject();
}

} // namespace

bool CardRow::loadsNowhere() const {
  return std::all_of(cells.begin(), cells.end(),
                     [](const CardCell &cell) { return cell.status == FileStatus::Invalid; });
}

bool CardRow::fitsNowhere() const {
  return std::none_of(cells.begin(), cells.end(),
                      [](const CardCell &cell) { return cell.status == FileStatus::Valid; });
}

CardMatrix::CardMatrix(std::string language, fp::LimitPolicy policy)
    : m_language(std::move(language)), m_policy(policy) {
  for (const std::string_view name : fp::hw::builtinNames())
    if (const fp::hw::Profile *const card = fp::hw::findBuiltin(name); !card->fromHost)
      m_cards.push_back(card);
}

std::string CardMatrix::add(const std::string &path) {
  const auto input = readInput(path);
  if (!input) {
    addFault();
    return input.error().message;
  }
  const std::string &text = input.value();
  ++m_files;
  for (const fp::FileProgram &program : choosePrograms(m_language, text)) {
    CardRow &row = m_rows.emplace_back();
    row.name = titleOf(path == "-" ? "<stdin>" : path, text, program);
    row.language = program.language;
    for (const fp::hw::Profile *card : m_cards)
      row.cells.push_back(cellOf(text, program, m_policy, *card));
  }
  return {};
}

std::size_t CardMatrix::fitting(std::size_t card) const {
  return std::size_t(std::count_if(m_rows.begin(), m_rows.end(), [card](const CardRow &row) {
    return row.cells[card].status == FileStatus::Valid;
  }));
}

std::string CardMatrix::text(const Style &style, bool reasons) const {
  const std::string total = "fit, of " + std::to_string(m_rows.size());
  std::size_t width = total.size();
  for (const CardRow &row : m_rows)
    width = std::max(width, shown(row.name).size());
  std::string head = padded("", width), text;
  for (const fp::hw::Profile *card : m_cards)
    head += "  " + padded(card->name, 4);
  text = painted(head, Colour::Dim, style) + "\n";
  for (const CardRow &row : m_rows) {
    text += padded(shown(row.name), width);
    for (std::size_t i = 0; i < m_cards.size(); ++i) {
      const CardCell &cell = row.cells[i];
      const bool last = i + 1 == m_cards.size();
      text += "  " + painted(word(cell), colourOf(cell), style);
      const std::size_t column = std::max<std::size_t>(m_cards[i]->name.size(), 4);
      text += last ? "" : std::string(column - std::string_view(word(cell)).size(), ' ');
    }
    text += "\n";
  }
  if (m_rows.size() > 1) {
    std::string counts = padded(total, width);
    for (std::size_t i = 0; i < m_cards.size(); ++i)
      counts += "  " + padded(std::to_string(fitting(i)),
                              std::max<std::size_t>(m_cards[i]->name.size(), 4));
    counts.erase(counts.find_last_not_of(' ') + 1);
    text += counts + "\n";
  }
  text += "fits: within the card's own limits; over: loads, and is over them; no: is refused, or "
          "the card has no such programs\n";
  for (const CardRow &row : m_rows)
    for (std::size_t i = 0; reasons && i < m_cards.size(); ++i)
      if (row.cells[i].status != FileStatus::Valid)
        text += shown(row.name) + ": " + m_cards[i]->name + ": " + reasonOf(row.cells[i]) + "\n";
  return text;
}

std::string CardMatrix::json() const {
  JsonWriter json;
  json.beginObject().key("schema").value(ARBITER_CHECK_SCHEMA);
  json.key("profiles").beginArray();
  for (const fp::hw::Profile *card : m_cards)
    json.beginObject()
        .key("name")
        .value(card->name)
        .key("description")
        .value(card->description)
        .endObject();
  json.endArray().key("files").beginArray();
  for (const CardRow &row : m_rows) {
    json.beginObject().key("file").value(row.name);
    json.key("language").value(languageRow(row.language).header + 2);
    json.key("cards").beginArray();
    for (std::size_t i = 0; i < m_cards.size(); ++i)
      writeCell(json, *m_cards[i], row.cells[i]);
    json.endArray().endObject();
  }
  json.endArray().key("summary").beginObject();
  json.key("files").value(std::uint64_t(m_files));
  json.key("unreadable").value(std::uint64_t(m_faults));
  json.key("fit").beginObject();
  for (std::size_t i = 0; i < m_cards.size(); ++i)
    json.key(m_cards[i]->name).value(std::uint64_t(fitting(i)));
  return json.endObject().endObject().endObject().take();
}

int CardMatrix::exitCode() const {
  const auto any = [this](bool (CardRow::*holds)() const) {
    return std::any_of(m_rows.begin(), m_rows.end(),
                       [holds](const CardRow &row) { return (row.*holds)(); });
  };
  if (m_faults != 0)
    return kExitUsage;
  if (any(&CardRow::loadsNowhere))
    return kExitInvalid;
  return any(&CardRow::fitsNowhere) ? kExitOverNative : kExitOk;
}

} // namespace arbiter::tools
