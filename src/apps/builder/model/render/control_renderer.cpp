#include "apps/builder/model/render/control_renderer.h"

#include <QDir>
#include <csignal>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include "apps/builder/model/text/edit.h"
#include "util/text/exit_codes.h"

namespace arbiter::builder {

namespace {

constexpr int kChildDescriptor = 3;
constexpr int kNice = 5;
constexpr qint64 kKeptRevisions = 64;

QStringList requestArguments(const RenderOptions &options, const QString &folder) {
  QStringList words{QStringLiteral("render"), QStringLiteral("--fd"),
                    QString::number(kChildDescriptor), QStringLiteral("--folder"),
                    folder.isEmpty() ? QStringLiteral(".") : folder};
  const auto add = [&](const char *name, const QString &value) {
    if (!value.isEmpty())
      words << QString::fromLatin1(name) << value;
  };
  add("--profile", options.profile);
  add("--numerics", options.numerics);
  add("--backend", options.backend);
  if (options.bare)
    words << QStringLiteral("--bare");
  return words;
}

} // namespace

ControlRenderer::~ControlRenderer() {
  if (!m_process)
    return;
  m_process->disconnect(this);
  m_client.reset(); // the process ends when its client does
  m_process->kill();
  m_process->waitForFinished(1000);
}

void ControlRenderer::start(const RenderOptions &options, const QString &folder) {
  int pair[2] = {-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) != 0) {
    Q_EMIT ended(tr("no socket for a renderer"));
    return;
  }
  m_client = std::make_unique<ControlClient>(pair[0]);
  m_process = new QProcess(this);
  m_process->setStandardErrorFile(QProcess::nullDevice());
  m_process->setStandardOutputFile(QProcess::nullDevice());
  const int theirs = pair[1];
  const pid_t parent = ::getpid();
  // Between fork and exec only async-signal-safe calls are allowed.
  m_process->setChildProcessModifier([theirs, parent] {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent)
      ::_exit(1);
    ::setpriority(PRIO_PROCESS, 0, ::getpriority(PRIO_PROCESS, 0) + kNice);
    if (theirs == kChildDescriptor) // dup2() would keep its close-on-exec flag
      ::fcntl(theirs, F_SETFD, 0);
    else
      ::dup2(theirs, kChildDescriptor);
  });
  connect(m_process, &QProcess::finished, this, [this](int code, QProcess::ExitStatus status) {
    if (m_client)
      m_client->read(); // its last answers may still be there
    if (!m_greeted && status == QProcess::NormalExit && code == kExitUsage)
      Q_EMIT unsupported();
    else
      finish(status == QProcess::CrashExit ? tr("the renderer was stopped by a signal")
                                           : tr("the renderer ended with code %1").arg(code));
  });
  connect(m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart)
      finish(tr("%1 cannot be started").arg(m_program));
  });
  connect(m_client.get(), &ControlClient::notified, this, &ControlRenderer::take);
  connect(m_client.get(), &ControlClient::frame, this, &ControlRenderer::takeFrame);
  // A renderer that violates the protocol is killed. One that has ended is reported by its process.
  connect(m_client.get(), &ControlClient::closed, this, &ControlRenderer::kill);
  m_process->start(m_program, requestArguments(options, folder));
  ::close(theirs);
  m_client->call(QStringLiteral("hello"), {{"client", "arbiter-builder"}},
                 [this](const QJsonObject &result, const QJsonObject &) {
                   m_greeted = m_greeted || !result.isEmpty();
                 });
  m_client->call(QStringLiteral("frame.want"), {{"every", 1}});
}

void ControlRenderer::finish(const QString &why) {
  if (!m_process)
    return;
  m_process->disconnect(this);
  m_process->deleteLater();
  m_process = nullptr;
  if (m_client)
    m_client.release()->deleteLater(); // one of its signals may have led here
  Q_EMIT ended(why);
}

void ControlRenderer::kill() {
  if (m_process)
    m_process->kill();
}

void ControlRenderer::draw(const Scene &scene) {
  if (!m_client)
    return;
  QJsonObject files;
  for (auto file = scene.files.cbegin(); file != scene.files.cend(); ++file)
    files[file.key()] = file.value();
  // The same text may be sent twice, but the protocol's revisions must increase.
  m_revisions.insert(++m_sent, scene.revision);
  m_revisions.remove(m_sent - kKeptRevisions);
  m_client->call(
      QStringLiteral("scene.set"),
      {{"text", scene.text}, {"revision", m_sent}, {"name", scene.name}, {"files", files}},
      [this, scene](const QJsonObject &result, const QJsonObject &error) {
        answer(result, error, scene);
      });
}

void ControlRenderer::answer(const QJsonObject &result, const QJsonObject &error,
                             const Scene &scene) {
  if (result.isEmpty() && error.isEmpty())
    return; // the process is gone; ended() reports it
  SceneAnswer answer;
  answer.revision = scene.revision;
  answer.ok = result[u"ok"].toBool();
  answer.superseded = result[u"superseded"].toBool();
  answer.animated = result[u"animated"].toBool();
  answer.milliseconds = result[u"milliseconds"].toDouble();
  const QByteArray bytes = scene.text.toUtf8();
  for (const QJsonValue each : result[u"diagnostics"].toArray()) {
    Problem problem = problemOfControl(each, bytes);
    if (problem.file == scene.name)
      problem.file.clear(); // an empty name is the text itself
    answer.problems.append(problem);
  }
  if (!error.isEmpty())
    answer.problems.append(
        {Severity::Error, QStringLiteral("renderer"), error[u"message"].toString(), {}, {}, 0, 0});
  Q_EMIT answered(answer);
}

void ControlRenderer::take(const QString &method, const QJsonObject &params) {
  if (method == u"busy")
    Q_EMIT busy(params[u"milliseconds"].toDouble());
}

void ControlRenderer::takeFrame(const QImage &image, const QJsonObject &params) {
  Q_EMIT drew({image, m_revisions.value(params[u"revision"].toInteger()),
               params[u"number"].toInteger(), params[u"time"].toDouble(),
               params[u"milliseconds"].toDouble(), params[u"steps"].toInt()});
}

bool ControlRenderer::setParameter(const LiveValue &live) {
  if (!m_client)
    return false;
  QJsonArray value;
  for (const auto &component : live.value)
    value.append(component ? QJsonValue(*component) : QJsonValue());
  m_client->call(
      QStringLiteral("scene.param"),
      {{"stage", live.stage}, {"kind", live.kind}, {"index", live.index}, {"value", value}});
  return true;
}

void ControlRenderer::setPaused(bool paused) {
  if (m_client)
    m_client->call(QStringLiteral("scene.pause"), {{"paused", paused}});
}

void ControlRenderer::step(double seconds) {
  if (m_client)
    m_client->call(QStringLiteral("scene.step"), {{"seconds", seconds}});
}

void ControlRenderer::setTime(double seconds) {
  if (m_client)
    m_client->call(QStringLiteral("scene.time"), {{"seconds", seconds}});
}

void ControlRenderer::setSteps(int steps) {
  if (m_client)
    m_client->call(QStringLiteral("scene.steps"), {{"steps", steps}});
}

bool ControlRenderer::bench(int frames) {
  if (!m_client)
    return false;
  m_client->call(QStringLiteral("scene.bench"), {{"frames", frames}},
                 [this](const QJsonObject &result, const QJsonObject &) {
                   Q_EMIT benched(result[u"frames"].toInt(), result[u"milliseconds"].toDouble(),
                                  result[u"median"].toDouble());
                 });
  return true;
}

} // namespace arbiter::builder
