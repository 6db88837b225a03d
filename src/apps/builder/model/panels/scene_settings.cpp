#include "apps/builder/model/panels/scene_settings.h"

#include <algorithm>
#include <cmath>

#include "apps/builder/model/panels/clauses.h"
#include "apps/builder/model/panels/utf_map.h"
#include "apps/scene/edit.h"
#include "apps/scene/panel/panel.h"

namespace arbiter::builder {

namespace {

QString qt(std::string_view text) { return QString::fromUtf8(text.data(), qsizetype(text.size())); }

template <typename Enum> QString wordOf(const std::optional<scene::Chosen<Enum>> &chosen) {
  return chosen ? qt(scene::rowOf(chosen->value).word) : QString();
}

QList<ArgumentValue> argumentsOf(const scene::WordRow &row, const scene::Arguments &arguments) {
  QList<ArgumentValue> all;
  const auto rows = row.arguments();
  for (std::size_t i = 0; i < rows.size(); ++i)
    all.append({qt(rows[i].word), arguments.numbers[i].value, rows[i].low, rows[i].high});
  return all;
}

template <typename Enum> QStringList wordsOfTable() {
  QStringList all;
  for (const scene::WordRow &row : scene::wordsOf<Enum>())
    if (!row.word.empty())
      all << qt(row.word);
  return all;
}

/// True if the mesh is a single shape with only its word and numbers.
bool isPlain(const scene::Panel &panel) {
  return panel.mesh.size() == 1 && panel.mesh[0].of.empty();
}

struct Place {
  const scene::WordRow *row = nullptr;
  const scene::Arguments *arguments = nullptr;
};

Place settingPlace(const scene::Panel &panel, const QString &setting) {
  if (setting == u"camera" && panel.camera)
    return {&scene::rowOf(panel.camera->kind.value), &panel.camera->arguments};
  if (setting == u"mesh" && isPlain(panel))
    return {&scene::rowOf(panel.mesh[0].shape.value), &panel.mesh[0].arguments};
  return {};
}

void applyTo(QString &text, const Edit &edit) {
  text.replace(edit.at, edit.removed.size(), edit.added);
}

} // namespace

SceneSettings sceneOf(const QString &text) {
  const scene::Panel panel = scene::parsePanel(text.toStdString());
  SceneSettings settings;
  settings.width = int(panel.width.value);
  settings.height = int(panel.height.value);
  settings.rate = panel.rate.value;
  if (const auto mesh = clauseOf(text, QStringLiteral("mesh")))
    settings.mesh = mesh->value;
  if (isPlain(panel)) {
    const scene::WordRow &row = scene::rowOf(panel.mesh[0].shape.value);
    settings.shape = qt(row.word);
    settings.shapeArguments = argumentsOf(row, panel.mesh[0].arguments);
  }
  if (panel.camera) {
    const scene::WordRow &row = scene::rowOf(panel.camera->kind.value);
    settings.camera = qt(row.word);
    settings.cameraArguments = argumentsOf(row, panel.camera->arguments);
  }
  settings.blend = wordOf(panel.state.blend);
  settings.depth = wordOf(panel.state.depth);
  settings.cull = wordOf(panel.state.cull);
  settings.stencil = wordOf(panel.state.stencil);
  settings.depthWrite = panel.state.depthWrite;
  settings.colorWrite = panel.state.colorWrite;
  settings.keep = panel.state.keep;
  for (std::size_t i = 0; i < panel.state.clear.size(); ++i)
    settings.clear[qsizetype(i)] = panel.state.clear[i].value;
  settings.vertex = QString::fromStdString(panel.vertex.text);
  for (const scene::Name &name : panel.then)
    settings.then << QString::fromStdString(name.text);
  return settings;
}

QStringList wordsFor(const QString &setting) {
  if (setting == u"mesh")
    return wordsOfTable<scene::Shape>();
  if (setting == u"camera")
    return wordsOfTable<scene::CameraKind>();
  if (setting == u"blend")
    return wordsOfTable<scene::Blend>();
  if (setting == u"depth")
    return wordsOfTable<scene::Depth>();
  if (setting == u"cull")
    return wordsOfTable<scene::Cull>();
  return setting == u"stencil" ? wordsOfTable<scene::Stencil>() : QStringList();
}

Edit setArgument(const QString &text, const QString &setting, const QString &name, double value) {
  const UtfMap map(text);
  const scene::Panel panel = scene::parsePanel(map.bytes());
  const Place place = settingPlace(panel, setting);
  const auto clause = clauseOf(text, setting);
  if (!place.row || !clause)
    return {};
  const auto rows = place.row->arguments();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (qt(rows[i].word) != name)
      continue;
    const scene::Number &number = place.arguments->numbers[i];
    const QString digits =
        QString::fromStdString(scene::numberText(std::clamp(value, rows[i].low, rows[i].high)));
    if (!number.written())
      return {clause->end, {}, u' ' + name + u' ' + digits};
    const qsizetype begin = map.unit(number.span.begin), end = map.unit(number.span.end);
    return {begin, text.mid(begin, end - begin), digits};
  }
  return {};
}

QList<Edit> turnCamera(const QString &text, double yaw, double pitch, double distance) {
  QString turned = text;
  QList<Edit> edits;
  const SceneSettings settings = sceneOf(text);
  if (settings.camera != u"orbit")
    return {};
  const auto rounded = [](double value) { return std::round(value * 100) / 100; };
  const auto change = [&](const QString &name, double value) {
    const Edit edit = setArgument(turned, QStringLiteral("camera"), name, rounded(value));
    if (edit.removed == edit.added)
      return;
    edits.append(edit);
    applyTo(turned, edit);
  };
  for (const ArgumentValue &each : settings.cameraArguments) {
    if (each.name == u"yaw" && yaw != 0)
      change(each.name, std::remainder(each.value + yaw, 360));
    else if (each.name == u"pitch" && pitch != 0)
      change(each.name, std::clamp(each.value + pitch, -90.0, 90.0));
    else if (each.name == u"distance" && distance != 1)
      change(each.name, each.value * distance);
  }
  return edits;
}

} // namespace arbiter::builder
