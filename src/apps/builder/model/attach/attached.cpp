#include "apps/builder/model/attach/attached.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QRegularExpression>
#include <cstring>

#include "control/address.h"

namespace arbiter::builder {

namespace {

constexpr qint64 kMaxSide = 512; ///< of a thumbnail, limited by the protocol

QString executableOf(qint64 process) {
  return QFileInfo(QFile::symLinkTarget(QStringLiteral("/proc/%1/exe").arg(process))).fileName();
}

} // namespace

QList<ListeningProcess> listeningProcesses(QString *why) {
  QList<ListeningProcess> processes;
  const auto folder = control::socketFolder();
  if (!folder) {
    if (why)
      *why = QString::fromStdString(folder.error().message);
    return processes;
  }
  for (const control::Listener &each : control::findListeners(folder.value()))
    if (each.kind == control::Kind::Layer)
      processes.append(
          {each.process, QString::fromStdString(each.path), executableOf(each.process)});
  return processes;
}

QString AttachedProgram::drawer() const {
  if (draws == 0)
    return {};
  if (rasterizerDraws == 0)
    return QStringLiteral("host");
  return rasterizerDraws >= draws ? QStringLiteral("rasterizer") : QStringLiteral("both");
}

AttachedProgram programOf(const QJsonObject &row) {
  AttachedProgram program;
  program.id = row[u"id"].toString();
  program.target = row[u"target"].toString();
  program.effective = row[u"effective"].toBool();
  program.edited = row[u"edited"].toBool();
  program.replaced = row[u"replaced"].toBool();
  program.enabled = row[u"enabled"].toBool(true);
  program.underNativeLimits = row[u"under_native_limits"].toBool(true);
  program.draws = row[u"draws"].toInteger();
  program.rasterizerDraws = row[u"rasterizer_draws"].toInteger();
  program.milliseconds = row[u"milliseconds"].toDouble();
  program.instructions = row[u"native_counts"][u"instructions"].toInteger();
  return program;
}

AttachedParameter parameterOf(const QJsonObject &row) {
  AttachedParameter parameter;
  parameter.name = row[u"name"].toString();
  parameter.kind = row[u"kind"].toString();
  parameter.held = row[u"held"].toBool();
  const QJsonArray value = row[u"value"].toArray();
  for (qsizetype i = 0; i < 4 && i < value.size(); ++i)
    parameter.value[std::size_t(i)] = value[i].toDouble();
  return parameter;
}

AttachedTexture textureOf(const QJsonObject &row) {
  AttachedTexture texture;
  texture.name = row[u"name"].toInteger();
  texture.unit = row[u"unit"].toInteger();
  texture.width = row[u"width"].toInteger();
  texture.height = row[u"height"].toInteger();
  texture.target = row[u"target"].toString();
  texture.format = row[u"format"].toString();
  return texture;
}

QImage imageOf(const QJsonObject &answer) {
  const QJsonObject json = answer[u"image"].toObject();
  const qint64 width = json[u"width"].toInteger(), height = json[u"height"].toInteger();
  const QByteArray bytes = QByteArray::fromBase64(json[u"rgba"].toString().toLatin1());
  if (width <= 0 || height <= 0 || width > kMaxSide || height > kMaxSide ||
      bytes.size() != width * height * 4)
    return {};
  QImage image(int(width), int(height), QImage::Format_RGBA8888);
  for (int y = 0; y < image.height(); ++y)
    std::memcpy(image.scanLine(y), bytes.constData() + (height - 1 - y) * width * 4,
                std::size_t(width) * 4);
  return image;
}

QString fileNameOf(const QString &id) {
  static const QRegularExpression s_name(QStringLiteral("^[0-9a-f]{1,64}\\.(fp|vp|atifs)\\z"));
  return s_name.match(id).hasMatch() ? id : QString();
}

} // namespace arbiter::builder
