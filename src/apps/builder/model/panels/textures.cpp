#include "apps/builder/model/panels/textures.h"

#include <QRegularExpression>
#include <QSet>

#include "apps/builder/model/panels/clauses.h"
#include "apps/builder/model/panels/utf_map.h"
#include "apps/builder/model/panels/words.h"
#include "apps/scene/panel/panel.h"

namespace arbiter::builder {

namespace {

bool standsAlone(scene::Generator generator) {
  switch (generator) {
  case scene::Generator::File:
  case scene::Generator::Normals:
  case scene::Generator::Normalize:
  case scene::Generator::Sky:
  case scene::Generator::Cube:
  case scene::Generator::Feedback:
  case scene::Generator::Picture:
  case scene::Generator::DepthOf:
    return false;
  default:
    return true;
  }
}

TextureLine textureLine(const scene::TextureSpec &spec, const QString &all, const UtfMap &map) {
  TextureLine line;
  line.unit = int(spec.unit);
  line.begin = map.unit(spec.span.begin);
  line.end = map.unit(spec.span.end);
  const QString clause = all.mid(line.begin, line.end - line.begin);
  line.source = clause.section(u'=', 1).section(u',', 0, 0).trimmed();
  line.filter = text(scene::rowOf(spec.filter.value).word);
  line.wrap = text(scene::rowOf(spec.wrap.value).word);
  line.isFile = spec.source.generator.value == scene::Generator::File;
  line.hasSides = line.isFile || standsAlone(spec.source.generator.value);
  line.line = placeOf(all, line.begin).line;
  return line;
}

} // namespace

QList<TextureLine> texturesOf(const QString &all) {
  QList<TextureLine> lines;
  const UtfMap map(all);
  const scene::Panel panel = scene::parsePanel(map.bytes());
  for (const scene::TextureSpec &spec : panel.textures)
    lines << textureLine(spec, all, map);
  return lines;
}

QList<GeneratorWord> generators() {
  QList<GeneratorWord> all;
  const auto rows = scene::wordsOf<scene::Generator>();
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (standsAlone(scene::Generator(i)))
      all << GeneratorWord{text(rows[i].word), text(rows[i].meaning)};
  return all;
}

Edit setTexture(const QString &all, int unit, const QString &source) {
  for (const TextureLine &line : texturesOf(all)) {
    if (line.unit != unit)
      continue;
    const qsizetype equals = all.indexOf(u'=', line.begin);
    qsizetype end = all.indexOf(u',', equals);
    if (end < 0 || end > line.end)
      end = line.end;
    return {equals + 1, all.mid(equals + 1, end - equals - 1), u' ' + source};
  }
  return addClause(all, QStringLiteral("texture %1 = %2").arg(unit).arg(source), {});
}

QStringList samplerWords(Sampler kind) {
  QStringList words;
  const auto rows =
      kind == Sampler::Filter ? scene::wordsOf<scene::Filter>() : scene::wordsOf<scene::Wrap>();
  for (const scene::WordRow &row : rows)
    words << text(row.word);
  return words;
}

Edit setSampler(const QString &all, int unit, Sampler kind, const QString &word) {
  const UtfMap map(all);
  const scene::Panel panel = scene::parsePanel(map.bytes());
  for (const scene::TextureSpec &spec : panel.textures) {
    if (int(spec.unit) != unit)
      continue;
    const fp::Span written = kind == Sampler::Filter ? spec.filter.span : spec.wrap.span;
    if (written.begin == written.end)
      return {map.unit(spec.span.end), {}, QStringLiteral(", ") + word};
    const qsizetype begin = map.unit(written.begin), end = map.unit(written.end);
    return {begin, all.mid(begin, end - begin), word};
  }
  return {};
}

QList<UnsetUnit> unsetUnits(const QString &all) {
  if (!all.trimmed().startsWith(QStringLiteral("!!ARBfp")))
    return {};
  QSet<int> known;
  for (const TextureLine &line : texturesOf(all))
    known.insert(line.unit);
  static const QRegularExpression kComment(QStringLiteral("#[^\n]*"));
  static const QRegularExpression kUnit(QStringLiteral("\\btexture\\s*\\[\\s*(\\d{1,2})\\s*\\]"));
  QString code = all;
  for (auto each = kComment.globalMatch(all); each.hasNext();) { // blanks keep the places
    const QRegularExpressionMatch comment = each.next();
    code.replace(comment.capturedStart(), comment.capturedLength(),
                 QString(comment.capturedLength(), u' '));
  }
  QList<UnsetUnit> unset;
  for (auto each = kUnit.globalMatch(code); each.hasNext();) {
    const QRegularExpressionMatch match = each.next();
    const int unit = match.captured(1).toInt();
    if (known.contains(unit))
      continue;
    known.insert(unit);
    unset.append({unit, match.capturedStart(), match.capturedEnd()});
  }
  return unset;
}

QString thumbnailDocument(const QString &source, int side) {
  return QStringLiteral("!!ARBfp1.0\n#@ size %1 %1\n#@ texture 0 = %2, nearest, edge\n"
                        "TEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
                        "MOV result.color, t;\nMOV result.color.a, 1.0;\nEND\n")
      .arg(side)
      .arg(source);
}

} // namespace arbiter::builder
