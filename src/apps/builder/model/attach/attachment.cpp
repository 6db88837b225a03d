#include "apps/builder/model/attach/attachment.h"

#include <QDir>
#include <QJsonArray>
#include <QSaveFile>
#include <algorithm>
#include <utility>

namespace arbiter::builder {

namespace {

constexpr int kAgain = 500;         ///< ms between requests of lists
constexpr int kPatience = 20000;    ///< ms for a trace
constexpr int kThumbnail = 96;      ///< pixels a side
constexpr int kImagesEach = 6;      ///< new thumbnails are requested with every n-th list
constexpr qint64 kMaxTextures = 64; ///< thumbnails

QString drawnText(const QJsonObject &program) {
  return program[u"edit"].isString() ? program[u"edit"].toString() : program[u"text"].toString();
}

/// Returns the bytes of the text that is drawn with, which may not be UTF-8.
QByteArray drawnBytes(const QJsonObject &program) {
  if (program[u"edit"].isString())
    return program[u"edit"].toString().toUtf8();
  if (program[u"text_base64"].isString())
    return QByteArray::fromBase64(program[u"text_base64"].toString().toLatin1());
  return program[u"text"].toString().toUtf8();
}

} // namespace

Attachment::Attachment(const QString &arbiter, QObject *parent)
    : QObject(parent), m_tracer(arbiter) {
  m_tracer.setPatience(kPatience);
  m_again.setInterval(kAgain);
  connect(&m_again, &QTimer::timeout, this, &Attachment::refresh);
}

/// Destroying the client answers pending requests; the answers are ignored.
Attachment::~Attachment() { delete m_client.release(); }

void Attachment::attach(const ListeningProcess &process) {
  detach();
  QString why;
  m_client = ControlClient::connectTo(process.path, why);
  if (!m_client)
    return Q_EMIT troubled(tr("process %1: %2").arg(process.process).arg(why));
  m_process = process;
  connect(m_client.get(), &ControlClient::closed, this,
          [this] { lost(tr("process %1 has ended, or hung up").arg(m_process.process)); });
  connect(m_client.get(), &ControlClient::frame, this, [this](const QImage &image) {
    m_picture = image.convertToFormat(QImage::Format_RGB32); // a window's alpha is not visible
    Q_EMIT pictureChanged();
  });
  connect(m_client.get(), &ControlClient::notified, this,
          [this](const QString &method, const QJsonObject &params) {
            if (method == u"busy")
              Q_EMIT busy(params[u"milliseconds"].toDouble());
          });
  m_client->call(QStringLiteral("hello"), {{"client", "arbiter-builder"}});
  ask(QStringLiteral("frame.want"), {{"every", 2}}, {}); // every pixel must be one of the frame's
  Q_EMIT attachedChanged();
  refresh();
}

void Attachment::detach() {
  if (!m_client)
    return;
  m_tracer.cancel();
  ControlClient *const gone = m_client.release();
  gone->close();
  gone->deleteLater(); // one of its signals may have led here
  m_programs.clear();
  m_parameters.clear();
  m_textures.clear();
  m_problems.clear();
  m_measured.clear();
  m_picture = {};
  m_selected.clear();
  m_ownText.clear();
  m_right = true;
  m_sending = false;
  m_waiting.reset();
  m_revision = 0;
  m_pixel.reset();
  Q_EMIT attachedChanged();
}

void Attachment::lost(const QString &why) {
  detach();
  Q_EMIT troubled(why);
}

void Attachment::setWatched(bool watched) { watched ? m_again.start() : m_again.stop(); }

/// Sends a request. It reports faults, and ignores what arrives after the client has gone.
void Attachment::ask(const QString &method, const QJsonObject &params, const Take &take) {
  if (!m_client)
    return;
  const ControlClient *const of = m_client.get();
  m_client->call(method, params,
                 [this, of, method, take](const QJsonObject &result, const QJsonObject &error) {
                   if (m_client.get() != of || !m_client->isOpen())
                     return;
                   if (!error.isEmpty())
                     Q_EMIT troubled(method + QStringLiteral(": ") + error[u"message"].toString());
                   else if (take)
                     take(result);
                 });
}

void Attachment::refresh() {
  ask(QStringLiteral("program.list"), {}, [this](const QJsonObject &r) { takePrograms(r); });
  ask(QStringLiteral("texture.list"), {}, [this](const QJsonObject &r) { takeTextures(r); });
  if (m_selected.isEmpty())
    return;
  ask(QStringLiteral("param.list"), {{"id", m_selected}}, [this](const QJsonObject &answer) {
    m_parameters.clear();
    for (const QJsonValue row : answer[u"parameters"].toArray())
      m_parameters.append(parameterOf(row.toObject()));
    Q_EMIT parametersChanged();
  });
}

void Attachment::takePrograms(const QJsonObject &answer) {
  m_programs.clear();
  for (const QJsonValue row : answer[u"programs"].toArray()) {
    AttachedProgram program = programOf(row.toObject());
    if (const auto cost = m_measured.constFind(program.id); cost != m_measured.cend())
      program.measured = *cost;
    m_programs.append(program);
  }
  // Programs that draw come first.
  std::stable_sort(m_programs.begin(), m_programs.end(), [](const auto &a, const auto &b) {
    return std::pair(a.effective, a.draws) > std::pair(b.effective, b.draws);
  });
  Q_EMIT programsChanged();
}

void Attachment::takeTextures(const QJsonObject &answer) {
  QList<AttachedTexture> textures;
  for (const QJsonValue row : answer[u"textures"].toArray())
    if (textures.size() < kMaxTextures)
      textures.append(textureOf(row.toObject()));
  const auto before = [&](const AttachedTexture &texture) {
    return std::find_if(m_textures.cbegin(), m_textures.cend(),
                        [&](const auto &old) { return old.isSame(texture); });
  };
  bool changed = textures.size() != m_textures.size();
  for (AttachedTexture &texture : textures) {
    const auto old = before(texture);
    if (old != m_textures.cend())
      texture.image = old->image;
    else
      changed = true;
  }
  m_textures = textures;
  if (changed)
    Q_EMIT texturesChanged();
  else if (++m_round % kImagesEach != 0) // reading textures is work for the application
    return;
  for (const AttachedTexture &texture : textures) // an unreadable texture has no image
    m_client->call(QStringLiteral("texture.get"),
                   {{"name", texture.name}, {"target", texture.target}, {"size", kThumbnail}},
                   [this, texture](const QJsonObject &image, const QJsonObject &) {
                     if (image.isEmpty())
                       return;
                     for (AttachedTexture &each : m_textures)
                       if (each.isSame(texture))
                         each.image = imageOf(image);
                     Q_EMIT texturesChanged();
                   });
}

void Attachment::select(const QString &id) {
  m_selected = id;
  m_problems.clear();
  m_parameters.clear();
  m_right = true;
  m_waiting.reset();
  ask(QStringLiteral("program.get"), {{"id", id}}, [this, id](const QJsonObject &program) {
    if (id != m_selected)
      return;
    m_ownText = program[u"text"].toString();
    m_revision = std::max(m_revision, program[u"revision"].toInteger());
    Q_EMIT textCame(drawnText(program));
    Q_EMIT judged();
  });
  refresh();
}

void Attachment::setText(const QString &text) {
  m_waiting = text;
  if (!m_sending)
    sendText();
}

void Attachment::sendText() {
  if (!m_client || m_selected.isEmpty() || !m_waiting)
    return;
  const QString text = *std::exchange(m_waiting, std::nullopt), id = m_selected;
  m_sending = true;
  const ControlClient *const of = m_client.get();
  m_client->call(QStringLiteral("program.set"),
                 {{"id", id}, {"text", text}, {"revision", ++m_revision}},
                 [this, of, id, text](const QJsonObject &result, const QJsonObject &error) {
                   if (m_client.get() != of || !m_client->isOpen())
                     return;
                   m_sending = false;
                   if (!error.isEmpty())
                     Q_EMIT troubled(error[u"message"].toString());
                   else if (id == m_selected)
                     takeVerdict(result, text);
                   sendText();
                 });
}

void Attachment::takeVerdict(const QJsonObject &answer, const QString &text) {
  const QByteArray bytes = text.toUtf8();
  m_problems.clear();
  for (const QJsonValue each : answer[u"diagnostics"].toArray())
    m_problems.append(problemOfControl(each.toObject(), bytes));
  m_right = answer[u"ok"].toBool();
  Q_EMIT judged();
}

void Attachment::putBack() {
  m_waiting.reset();
  ask(QStringLiteral("program.reset"), {{"id", m_selected}}, [this](const QJsonObject &) {
    m_problems.clear();
    m_right = true;
    Q_EMIT textCame(m_ownText);
    Q_EMIT judged();
    refresh();
  });
}

void Attachment::setEnabled(bool enabled) {
  ask(QStringLiteral("program.enable"), {{"id", m_selected}, {"enabled", enabled}},
      [this](const QJsonObject &) { refresh(); });
}

void Attachment::setParameter(const QString &name, const std::array<double, 4> &value) {
  ask(QStringLiteral("param.set"),
      {{"id", m_selected},
       {"name", name},
       {"value", QJsonArray{value[0], value[1], value[2], value[3]}}},
      {});
}

void Attachment::letGo(const QString &name) {
  ask(QStringLiteral("param.reset"), {{"id", m_selected}, {"name", name}},
      [this](const QJsonObject &) { refresh(); });
}

void Attachment::measure() {
  ask(QStringLiteral("frame.measure"), {}, [this](const QJsonObject &answer) {
    m_measured.clear();
    const QJsonObject programs = answer[u"programs"].toObject();
    for (auto each = programs.constBegin(); each != programs.constEnd(); ++each) {
      const QJsonObject row = each->toObject();
      MeasuredCost cost;
      cost.draws = row[u"draws"].toInteger();
      if (row[u"pixels"].isDouble())
        cost.pixels = row[u"pixels"].toInteger();
      cost.milliseconds = row[u"milliseconds"].toDouble();
      m_measured.insert(each.key(), cost);
    }
    refresh();
  });
}

void Attachment::exportTo(const QString &folder) {
  if (!QDir().mkpath(folder))
    return Q_EMIT troubled(tr("%1 cannot be made").arg(folder));
  ask(QStringLiteral("program.list"), {}, [this, folder](const QJsonObject &answer) {
    QStringList ids;
    for (const QJsonValue row : answer[u"programs"].toArray())
      if (const QString id = fileNameOf(row[u"id"].toString()); !id.isEmpty())
        ids << id;
    exportNext(folder, ids, 0);
  });
}

void Attachment::exportNext(const QString &folder, QStringList left, int done) {
  if (left.isEmpty())
    return Q_EMIT exported(folder, done);
  const QString id = left.takeFirst();
  ask(QStringLiteral("program.get"), {{"id", id}},
      [this, folder, left, done, id](const QJsonObject &program) {
        QSaveFile file(QDir(folder).filePath(id));
        const QByteArray bytes = drawnBytes(program);
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit())
          return Q_EMIT troubled(tr("%1: %2").arg(file.fileName(), file.errorString()));
        exportNext(folder, left, done + 1);
      });
}

void Attachment::tracePixel(QPoint pixel) {
  if (!m_client)
    return;
  m_pixel = pixel;
  Q_EMIT pictureChanged(); // the picture's mark has changed
  m_tracer.run({QStringLiteral("ctl"), QStringLiteral("--json"), QStringLiteral("--pid"),
                QString::number(m_process.process), QStringLiteral("--timeout"),
                QStringLiteral("15"), QStringLiteral("trace"),
                QStringLiteral("%1,%2").arg(pixel.x()).arg(pixel.y())},
               {}, [this](const ToolResult &result) {
                 const QJsonObject json = result.json();
                 if (json[u"rows"].isArray())
                   return Q_EMIT traced(json);
                 Q_EMIT troubled(result.complaint.isEmpty()
                                     ? tr("the trace ended with code %1").arg(result.code)
                                     : result.complaint.trimmed());
               });
}

} // namespace arbiter::builder
