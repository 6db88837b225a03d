#include "builder/model/panels/textures.h"

#include "builder/model/panels/utf_map.h"
#include "scene/edit.h"
#include "scene/panel/panel.h"

namespace arbiter::builder {

namespace {

QString text(std::string_view view) {
  return QString::fromUtf8(view.data(), qsizetype(view.size()));
}

TextureLine lineOf(const scene::TextureSpec &spec, const QString &all, const UtfMap &map) {
  TextureLine line;
  line.unit = int(spec.unit);
  line.begin = map.unit(spec.span.begin);
  line.end = map.unit(spec.span.end);
  const QString clause = all.mid(line.begin, line.end - line.begin);
  line.source = clause.section(u'=', 1).section(u',', 0, 0).trimmed();
  line.filter = text(scene::rowOf(spec.filter.value).word);
  line.wrap = text(scene::rowOf(spec.wrap.value).word);
  line.isFile = spec.source.generator.value == scene::Generator::File;
  line.line = placeOf(all, line.begin).line;
  return line;
}

bool standsAlone(scene::Generator generator) {
  switch (generator) {
  case scene::Generator::File:
  case scene::Generator::Normals:
  case scene::Generator::Normalise:
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

} // namespace

QList<TextureLine> texturesOf(const QString &all) {
  QList<TextureLine> lines;
  const UtfMap map(all);
  const scene::Panel panel = scene::parsePanel(map.bytes());
  for (const scene::TextureSpec &spec : panel.textures)
    lines << lineOf(spec, all, map);
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
  const UtfMap map(all);
  const std::string words = QStringLiteral("texture %1 = %2").arg(unit).arg(source).toStdString();
  const scene::Edit added = scene::addLine(map.bytes(), words);
  const qsizetype begin = map.unit(added.span.begin), end = map.unit(added.span.end);
  return {begin, all.mid(begin, end - begin), QString::fromStdString(added.text)};
}

QString thumbnailDocument(const QString &source, int side) {
  return QStringLiteral("!!ARBfp1.0\n#@ size %1 %1\n#@ texture 0 = %2, nearest, edge\n"
                        "TEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
                        "MOV result.color, t;\nMOV result.color.a, 1.0;\nEND\n")
      .arg(side)
      .arg(source);
}

} // namespace arbiter::builder
