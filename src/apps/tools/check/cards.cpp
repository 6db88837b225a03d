#include "apps/tools/check/cards.h"

#include <algorithm>
#include <array>

#include <GL/arbiter.h>

#include "apps/tools/check/why.h"
#include "apps/tools/commands.h"
#include "apps/tools/input.h"
#include "apps/tools/language.h"
#include "fp_compiler/resources.h"
#include "util/json.h"

namespace arbiter::tools {

namespace {

/// Returns the errors, each with its line and column.
std::vector<std::string> errorsOf(const fp::CheckResult &result, const std::string &text) {
  std::vector<std::string> errors;
  for (const fp::Diagnostic &diagnostic : result.diagnostics) {
    if (diagnostic.severity != fp::Severity::Error)
      continue;
    const fp::LineColumn at = fp::locate(text, diagnostic.span.begin);
    errors.push_back(std::to_string(at.line) + ":" + std::to_string(at.column) + ": " +
                     diagnostic.message);
  }
  return errors;
}

void takeErrors(const std::vector<std::string> &errors, bool details, CardCell &cell) {
  if (!errors.empty())
    cell.why = errors.front();
  for (std::size_t i = 1; details && i < errors.size(); ++i)
    cell.details += "  " + errors[i] + "\n";
}

/// Takes the model's reasons for the counts of a card that runs the program itself.
void takeReasons(const CheckedFile &file, const std::optional<Style> &details, CardCell &cell) {
  // A reason without instructions holds for every program.
  const auto isOver = [&cell](const fp::hw::Reason &reason) {
    return !reason.instructions.empty() &&
           std::any_of(cell.over.begin(), cell.over.end(), [&reason](const OverCount &over) {
             return over.row->member == reason.resource;
           });
  };
  const std::vector<fp::hw::Reason> &reasons = file.native().reasons;
  if (const auto found = std::find_if(reasons.begin(), reasons.end(), isOver);
      found != reasons.end())
    cell.why = found->text;
  if (!details)
    return;
  const Why why(file, *details, true);
  for (const OverCount &over : cell.over) {
    if (cell.over.size() > 1)
      cell.details += std::string("  ") + over.row->title + ":\n";
    cell.details += why.reasons(*over.row);
    if (over.row->member == &fp::ResourceCounts::texIndirections)
      cell.details += why.chain();
  }
}

CardCell cellOf(const std::string &text, const fp::FileProgram &program, fp::LimitPolicy policy,
                const fp::hw::Profile &card, const std::optional<Style> &details) {
  CheckedFile file;
  file.text = text;
  file.language = program.language;
  file.limits = limitsOf(card, file.language);
  file.result = fp::checkProgramIn(text, program, {file.limits, policy});
  CardCell cell;
  cell.hasLanguage = hasPrograms(file.limits, file.language);
  cell.runsItself = file.lack().empty();
  if (!file.result.ok()) {
    cell.status = FileStatus::Invalid;
    cell.why = file.lack();
    if (cell.hasLanguage)
      takeErrors(errorsOf(file.result, text), details.has_value(), cell);
    return cell;
  }
  if (file.result.underNativeLimits)
    return cell;
  cell.status = file.status = FileStatus::OverNative;
  for (const fp::ResourceRow &row : fp::resourceRows()) {
    const std::uint32_t used = file.result.nativeCounts.*row.member;
    const std::uint32_t limit = file.limits.native.*row.member;
    if (row.of(file.language) && used > limit)
      cell.over.push_back({&row, used, limit});
  }
  if (cell.runsItself)
    takeReasons(file, details, cell);
  else
    cell.why = file.lack();
  return cell;
}

/// Returns the card's name as people say it, "Radeon 9700" of "ATI Radeon 9700 (r300)"; empty if
/// the profile's description names none.
std::string_view spokenName(const fp::hw::Profile &card) {
  std::string_view name = card.fragment.card;
  const std::size_t chip = name.rfind(" (");
  if (chip == std::string_view::npos)
    return {};
  name = name.substr(0, chip);
  name = name.substr(0, name.find(" and "));
  return name.substr(name.find(' ') + 1);
}

/// Returns the name's first word and the others, for two lines of a table's head.
std::array<std::string, 2> linesOf(std::string_view name) {
  const std::size_t end = std::min(name.find(' '), name.size());
  return {std::string(name.substr(0, end)),
          std::string(name.substr(std::min(end + 1, name.size())))};
}

bool loads(const CardCell &cell) {
  return cell.status == FileStatus::OverNative && cell.hasLanguage;
}

const char *word(const CardCell &cell) {
  return cell.status == FileStatus::Valid ? "fits" : loads(cell) ? "over" : "no";
}

Color colorOfCell(const CardCell &cell) {
  return cell.status == FileStatus::Valid ? Color::Good : loads(cell) ? Color::Close : Color::Bad;
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

CardMatrix::CardMatrix(std::string language, fp::LimitPolicy policy, std::optional<Style> details)
    : m_language(std::move(language)), m_policy(policy), m_details(details) {
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
      row.cells.push_back(cellOf(text, program, m_policy, *card, m_details));
  }
  return {};
}

std::size_t CardMatrix::fitting(std::size_t card) const {
  return std::size_t(std::count_if(m_rows.begin(), m_rows.end(), [card](const CardRow &row) {
    return row.cells[card].status == FileStatus::Valid;
  }));
}

std::size_t CardMatrix::columnOf(std::size_t card) const {
  std::size_t width = std::max<std::size_t>(m_cards[card]->name.size(), 4);
  for (const std::string &line : linesOf(spokenName(*m_cards[card])))
    width = std::max(width, line.size());
  return width;
}

std::string CardMatrix::head(std::size_t width, const Style &style) const {
  std::string text;
  for (std::size_t line = 0; line < 3; ++line) {
    std::string cells = padded("", width);
    for (std::size_t i = 0; i < m_cards.size(); ++i)
      cells += "  " + padded(line < 2 ? linesOf(spokenName(*m_cards[i]))[line] : m_cards[i]->name,
                             columnOf(i));
    cells.erase(cells.find_last_not_of(' ') + 1);
    text += painted(cells, Color::Dim, style) + "\n";
  }
  return text;
}

std::string CardMatrix::outcome() const {
  std::size_t fit = 0, load = 0;
  for (const CardRow &row : m_rows) {
    fit += row.fitsNowhere() ? 0 : 1;
    load += row.fitsNowhere() && !row.loadsNowhere() ? 1 : 0;
  }
  std::string text = "fit at least one card: " + std::to_string(fit) + " of " +
                     std::to_string(m_rows.size()) +
                     (m_rows.size() == 1 ? " program" : " programs");
  if (load != 0)
    text += ", load and fit none: " + std::to_string(load);
  if (const std::size_t refused = m_rows.size() - fit - load; refused != 0)
    text += ", refused by all: " + std::to_string(refused);
  return text + "\n";
}

std::string CardMatrix::reasonsOf(const CardRow &row) const {
  struct Group {
    std::string cards, reason;
  };
  std::vector<Group> groups;
  for (std::size_t i = 0; i < m_cards.size(); ++i) {
    const CardCell &cell = row.cells[i];
    if (cell.status == FileStatus::Valid)
      continue;
    std::string reason = reasonOf(cell) + "\n" + cell.details;
    const auto same = std::find_if(groups.begin(), groups.end(),
                                   [&](const Group &each) { return each.reason == reason; });
    if (same == groups.end())
      groups.push_back({m_cards[i]->name, std::move(reason)});
    else
      same->cards += ", " + m_cards[i]->name;
  }
  std::string text;
  for (const Group &group : groups)
    text += shown(row.name) + ": " + group.cards + ": " + group.reason;
  return text;
}

std::string CardMatrix::text(const Style &style, bool reasons) const {
  const std::string total = "fit, of " + std::to_string(m_rows.size());
  std::size_t width = total.size();
  for (const CardRow &row : m_rows)
    width = std::max(width, shown(row.name).size());
  std::string text = head(width, style);
  for (const CardRow &row : m_rows) {
    text += padded(shown(row.name), width);
    for (std::size_t i = 0; i < m_cards.size(); ++i) {
      const CardCell &cell = row.cells[i];
      const bool last = i + 1 == m_cards.size();
      text += "  " + painted(word(cell), colorOfCell(cell), style);
      text += last ? "" : std::string(columnOf(i) - std::string_view(word(cell)).size(), ' ');
    }
    text += "\n";
  }
  if (m_rows.size() > 1) {
    std::string counts = padded(total, width);
    for (std::size_t i = 0; i < m_cards.size(); ++i)
      counts += "  " + padded(std::to_string(fitting(i)), columnOf(i));
    counts.erase(counts.find_last_not_of(' ') + 1);
    text += counts + "\n";
  }
  text += "fits: within the card's own limits; over: loads, and is over them; no: is refused, or "
          "the card has no such programs\n" +
          outcome();
  for (const CardRow &row : m_rows)
    text += reasons ? reasonsOf(row) : "";
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
  json.key("valid_by_profile").beginObject();
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
