#include "apps/builder/model/panels/words.h"

#include <algorithm>

#include "apps/scene/words.h"
#include "fp_compiler/front/reference/reference.h"

namespace arbiter::builder {

namespace {

using fp::ir::Language;
namespace reference = fp::reference;

QString signatureOf(fp::ir::Opcode op, const fp::ir::OpInfo &info) {
  QStringList operands;
  if (!info.has(fp::ir::Kills))
    operands << QStringLiteral("result");
  for (int i = 0; i < info.operandCount(); ++i)
    operands << QString(QChar(u'a' + i)) +
                    (info.shapes[i] == 'S' ? QStringLiteral(".x") : QString());
  if (info.has(fp::ir::Texture))
    operands << QStringLiteral("texture[n]") << QStringLiteral("2D");
  static_cast<void>(op);
  return QStringLiteral("%1 %2").arg(QString::fromLatin1(info.mnemonic), operands.join(u", "));
}

void addOpcodes(QList<Word> &all) {
  for (std::size_t i = 0; i < std::size_t(fp::ir::kOpcodeCount); ++i) {
    const auto op = fp::ir::Opcode(i);
    const fp::ir::OpInfo &info = fp::ir::info(op);
    all.append({WordKind::Opcode, QString::fromLatin1(info.mnemonic), signatureOf(op, info),
                text(reference::formula(op)), QString::fromLatin1(info.doc),
                QString::fromLatin1(info.section), !info.has(fp::ir::VertexOnly),
                !info.has(fp::ir::FragmentOnly)});
  }
}

/// Adds a word; a word that both languages have is one row.
void add(QList<Word> &all, Word word) {
  for (Word &other : all)
    if (other.kind == word.kind && other.word == word.word) {
      other.fragment = other.fragment || word.fragment;
      other.vertex = other.vertex || word.vertex;
      return;
    }
  all.append(std::move(word));
}

void addEntries(QList<Word> &all, WordKind kind, std::span<const reference::Entry> entries,
                bool fragment) {
  for (const reference::Entry &entry : entries)
    add(all, {kind,
              text(entry.word),
              text(entry.word),
              {},
              text(entry.doc),
              text(entry.section),
              fragment,
              !fragment});
}

void addBindings(QList<Word> &all, Language language) {
  const bool fragment = language == Language::ArbFragment;
  for (const reference::Binding &binding : reference::bindings(language)) {
    const QString path = QString::fromStdString(binding.path());
    add(all, {WordKind::Binding,
              path,
              path + QStringLiteral("  ") + text(binding.components),
              {},
              text(binding.doc),
              text(binding.section),
              fragment,
              !fragment});
  }
}

template <typename Enum> void addPanel(QList<Word> &all) {
  for (const scene::WordRow &row : scene::wordsOf<Enum>()) {
    if (row.word.empty())
      continue;
    QString signature = QStringLiteral("#@ ") + text(row.word);
    if (!row.form.empty())
      signature += u' ' + text(row.form);
    for (const scene::ArgumentRow &argument : row.arguments())
      signature += QStringLiteral(" [%1 %2]").arg(text(argument.word)).arg(argument.fallback);
    all.append({WordKind::Panel, text(row.word), signature, {}, text(row.meaning), {}, true, true});
  }
}

QList<Word> collect() {
  QList<Word> all;
  addOpcodes(all);
  for (const Language language : {Language::ArbFragment, Language::ArbVertex}) {
    const bool fragment = language == Language::ArbFragment;
    addEntries(all, WordKind::Keyword, reference::keywords(language), fragment);
    addEntries(all, WordKind::Option, reference::options(language), fragment);
  }
  addEntries(all, WordKind::Target, reference::targets(), true);
  addBindings(all, Language::ArbFragment);
  addBindings(all, Language::ArbVertex);
  addPanel<scene::Setting>(all);
  addPanel<scene::Generator>(all);
  addPanel<scene::Shape>(all);
  addPanel<scene::AnimationKind>(all);
  addPanel<scene::Blend>(all);
  return all;
}

int rank(const Word &word, const QString &search) {
  if (word.word.startsWith(search, Qt::CaseInsensitive))
    return 0;
  if (word.word.contains(search, Qt::CaseInsensitive))
    return 1;
  return word.doc.contains(search, Qt::CaseInsensitive) ? 2 : 3;
}

} // namespace

QString nameOf(WordKind kind) {
  switch (kind) {
  case WordKind::Opcode:
    return QStringLiteral("instruction");
  case WordKind::Keyword:
    return QStringLiteral("keyword");
  case WordKind::Option:
    return QStringLiteral("option");
  case WordKind::Target:
    return QStringLiteral("texture target");
  case WordKind::Binding:
    return QStringLiteral("binding");
  case WordKind::Panel:
    return QStringLiteral("#@ word");
  }
  return {};
}

const QList<Word> &allWords() {
  static const QList<Word> all = collect();
  return all;
}

QList<Word> searchWords(const QString &search) {
  const QString wanted = search.trimmed();
  QList<std::pair<int, Word>> found;
  for (const Word &word : allWords())
    if (const int r = wanted.isEmpty() ? 0 : rank(word, wanted); r < 3)
      found.append({r, word});
  std::stable_sort(found.begin(), found.end(),
                   [](const auto &a, const auto &b) { return a.first < b.first; });
  QList<Word> words;
  for (const auto &[r, word] : found)
    words.append(word);
  return words;
}

Language languageOf(const QString &text) {
  if (text.startsWith(QStringLiteral("!!ARBvp")))
    return Language::ArbVertex;
  if (text.startsWith(QStringLiteral("!!ATIfs")))
    return Language::AtiFragment;
  if (text.startsWith(QStringLiteral("!!RC")))
    return Language::Combiners;
  if (text.startsWith(QStringLiteral("!!TS")))
    return Language::TextureShaders;
  return Language::ArbFragment;
}

} // namespace arbiter::builder
