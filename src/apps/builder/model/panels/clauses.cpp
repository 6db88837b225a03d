#include "apps/builder/model/panels/clauses.h"

#include "apps/builder/model/panels/utf_map.h"
#include "apps/scene/edit.h"
#include "apps/scene/panel/token.h"

namespace arbiter::builder {

namespace {

/// Splits one line into clauses.
class Line {
public:
  Line(const QString &text, const UtfMap &map) : m_text(text), m_map(map) {}

  QList<Clause> read(const std::vector<scene::Token> &tokens) {
    QList<Clause> clauses;
    std::size_t from = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      if (tokens[i].kind != scene::TokenKind::Comma && tokens[i].kind != scene::TokenKind::End)
        continue;
      if (i > from)
        clauses.append(clause(tokens[from], tokens[i - 1]));
      from = i + 1;
    }
    if (!clauses.isEmpty())
      clauses.first().first = true;
    if (clauses.size() == 1)
      clauses.first().alone = true;
    return clauses;
  }

private:
  [[nodiscard]] Clause clause(const scene::Token &word, const scene::Token &last) const {
    Clause made;
    made.begin = m_map.unit(word.span.begin);
    made.end = m_map.unit(last.span.end);
    made.word = m_text.mid(made.begin, m_map.unit(word.span.end) - made.begin);
    made.valueBegin = m_map.unit(word.span.end);
    while (made.valueBegin < made.end && m_text[made.valueBegin].isSpace())
      ++made.valueBegin;
    made.value = m_text.mid(made.valueBegin, made.end - made.valueBegin);
    return made;
  }

  const QString &m_text;
  const UtfMap &m_map;
};

QString spelled(const QString &word, const QString &value) {
  return value.isEmpty() ? word : word + u' ' + value;
}

bool endsLine(QChar c) { return c == u'\n' || c == u'\r'; }

/// Removes the clause's whole line with its end, so that no empty line stays.
Edit removeLine(const QString &text, const Clause &clause) {
  qsizetype begin = clause.begin, end = clause.end;
  while (begin > 0 && !endsLine(text[begin - 1]))
    --begin;
  while (end < text.size() && !endsLine(text[end]))
    ++end;
  if (end < text.size())
    end += text.mid(end, 2) == QStringLiteral("\r\n") ? 2 : 1;
  else if (begin > 0)
    begin -= text.mid(std::max<qsizetype>(begin - 2, 0), 2) == QStringLiteral("\r\n") ? 2 : 1;
  return {begin, text.mid(begin, end - begin), {}};
}

} // namespace

QList<Clause> clausesOf(const QString &text) {
  QList<Clause> all;
  const UtfMap map(text);
  Line line(text, map);
  for (const fp::Span span : scene::panelLines(map.bytes()))
    all += line.read(scene::tokenise(map.bytes(), span));
  return all;
}

std::optional<Clause> clauseOf(const QString &text, const QString &word) {
  for (const Clause &clause : clausesOf(text))
    if (clause.word == word)
      return clause;
  return std::nullopt;
}

Edit setClause(const QString &text, const QString &word, const QString &value) {
  const auto clause = clauseOf(text, word);
  if (!clause)
    return addClause(text, word, value);
  return {clause->begin, text.mid(clause->begin, clause->end - clause->begin),
          spelled(word, value)};
}

Edit addClause(const QString &text, const QString &word, const QString &value) {
  const UtfMap map(text);
  const scene::Edit added = scene::addLine(map.bytes(), spelled(word, value).toStdString());
  const qsizetype begin = map.unit(added.span.begin), end = map.unit(added.span.end);
  return {begin, text.mid(begin, end - begin), QString::fromStdString(added.text)};
}

Edit removeClause(const QString &text, const Clause &clause) {
  if (clause.alone)
    return removeLine(text, clause);
  qsizetype begin = clause.begin, end = clause.end;
  if (clause.first) {
    end = text.indexOf(u',', end) + 1; // it is not alone, so that there is a comma
    while (end < text.size() && (text[end] == u' ' || text[end] == u'\t'))
      ++end;
  } else {
    begin = text.lastIndexOf(u',', begin);
  }
  return {begin, text.mid(begin, end - begin), {}};
}

QString quotedName(const QString &name) {
  bool plain = name.contains(u'.') && !name.isEmpty() && name[0].unicode() < 128 &&
               name[0].isLetter() && !name.contains(QStringLiteral(".."));
  for (const QChar c : name)
    plain = plain && c.unicode() < 128 &&
            (c.isLetterOrNumber() || c == u'_' || c == u'-' || c == u'.' || c == u'/');
  return plain ? name : u'"' + name + u'"';
}

} // namespace arbiter::builder
