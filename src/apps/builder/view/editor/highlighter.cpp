#include "apps/builder/view/editor/highlighter.h"

#include "apps/builder/view/theme.h"
#include "fp_compiler/front/reference/reference.h"

namespace arbiter::builder {

namespace {

QColor colorOf(WordKind kind) {
  const Colors &c = colors();
  switch (kind) {
  case WordKind::Opcode:
    return c.opcode;
  case WordKind::Keyword:
    return c.keyword;
  case WordKind::Option:
  case WordKind::Target:
    return c.option;
  case WordKind::Binding:
    return c.binding;
  case WordKind::Panel:
    return c.panel;
  }
  return c.text;
}

} // namespace

Highlighter::Highlighter(QTextDocument *document) : QSyntaxHighlighter(document) {
  for (const Word &word : allWords()) {
    if (word.kind == WordKind::Panel) {
      m_panel.insert(word.word, word.kind);
      continue;
    }
    if (word.kind == WordKind::Binding) // only the first word; the others follow a dot
      m_words.insert(word.word.section(QRegularExpression(QStringLiteral("[.\\[]")), 0, 0),
                     word.kind);
    else
      m_words.insert(word.word, word.kind);
    if (word.kind == WordKind::Opcode && word.fragment)
      m_words.insert(word.word + QStringLiteral("_SAT"), word.kind);
  }
  for (const auto &op : fp::reference::atiOps())
    m_words.insert(QString::fromUtf8(op.word.data(), qsizetype(op.word.size())), WordKind::Opcode);
  for (const auto &entry : fp::reference::atiStatements())
    m_words.insert(QString::fromUtf8(entry.word.data(), qsizetype(entry.word.size())),
                   WordKind::Keyword);
}

void Highlighter::refresh() { rehighlight(); }

qsizetype Highlighter::word(const QString &text, qsizetype begin) {
  qsizetype end = begin;
  while (end < text.size() && inWord(text[end]))
    ++end;
  const QString word = text.mid(begin, end - begin);
  const auto found = m_words.constFind(word);
  if (found != m_words.constEnd())
    setFormat(int(begin), int(end - begin), colorOf(*found));
  // The words behind dots and indices belong to the same binding.
  if (found != m_words.constEnd() && *found == WordKind::Binding) {
    qsizetype chain = end;
    while (chain + 1 < text.size() && text[chain] == u'.' && beginsWord(text[chain + 1])) {
      ++chain;
      while (chain < text.size() && inWord(text[chain]))
        ++chain;
      setFormat(int(end), int(chain - end), colors().binding);
      const qsizetype close =
          chain < text.size() && text[chain] == u'[' ? text.indexOf(u']', chain) : qsizetype(-1);
      if (close < 0)
        break;
      for (qsizetype i = chain; i < close;)
        i = text[i].isDigit() ? number(text, i) : i + 1;
      chain = close + 1;
      end = chain;
    }
    return std::max(end, chain);
  }
  if (found == m_words.constEnd() && begin > 0 && text[begin - 1] == u'.')
    setFormat(int(begin), int(end - begin), colors().parameter); // a mask, swizzle or field
  return end;
}

qsizetype Highlighter::number(const QString &text, qsizetype begin) {
  qsizetype end = begin;
  bool exponent = false;
  while (end < text.size() && (text[end].isDigit() || text[end] == u'.' ||
                               (!exponent && (text[end] == u'e' || text[end] == u'E')) ||
                               (exponent && (text[end] == u'+' || text[end] == u'-')))) {
    exponent = text[end] == u'e' || text[end] == u'E';
    ++end;
  }
  if (end == begin + 1 && end + 0 < text.size() && text[end] == u'D') { // 1D, 2D, 3D
    setFormat(int(begin), 2, colors().option);
    return end + 1;
  }
  setFormat(int(begin), int(end - begin), colors().number);
  return end;
}

void Highlighter::panelLine(const QString &text, qsizetype begin) {
  setFormat(int(begin), int(text.size() - begin), colors().dim);
  setFormat(int(begin), 2, colors().panel);
  for (qsizetype i = begin + 2; i < text.size();) {
    if (text[i] == u'"') {
      const qsizetype close = text.indexOf(u'"', i + 1);
      const qsizetype end = close < 0 ? text.size() : close + 1;
      setFormat(int(i), int(end - i), colors().parameter);
      i = end;
    } else if (beginsWord(text[i])) {
      qsizetype end = i;
      while (end < text.size() && inWord(text[end]))
        ++end;
      if (m_panel.contains(text.mid(i, end - i)))
        setFormat(int(i), int(end - i), colors().panel);
      i = end;
    } else if (text[i].isDigit()) {
      i = number(text, i);
    } else {
      ++i;
    }
  }
}

void Highlighter::highlightBlock(const QString &text) {
  if (currentBlock().blockNumber() == 0 && text.startsWith(u"!!")) {
    setFormat(0, int(text.size()), colors().keyword);
    return;
  }
  for (qsizetype i = 0; i < text.size();) {
    if (text[i] == u'#') {
      if (i + 1 < text.size() && text[i + 1] == u'@')
        panelLine(text, i);
      else
        setFormat(int(i), int(text.size() - i), colors().comment);
      return;
    }
    if (beginsWord(text[i]))
      i = word(text, i);
    else if (text[i].isDigit())
      i = number(text, i);
    else
      ++i;
  }
}

} // namespace arbiter::builder
