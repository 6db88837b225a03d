#include "apps/builder/model/render/draw_renderer.h"

#include <csignal>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "apps/builder/model/render/work_folder.h"
#include "util/text/exit_codes.h"

namespace arbiter::builder {

namespace {

QStringList argumentsOf(const RenderOptions &options, const QString &document,
                        const QString &picture) {
  QStringList words{QStringLiteral("draw"), QStringLiteral("-o"), picture};
  if (options.bare)
    words << QStringLiteral("--bare");
  if (!options.bare && !options.profile.isEmpty())
    words << QStringLiteral("--profile") << options.profile;
  if (!options.bare && !options.numerics.isEmpty())
    words << QStringLiteral("--numerics") << options.numerics;
  if (!options.bare && !options.backend.isEmpty())
    words << QStringLiteral("--backend") << options.backend;
  return words << document;
}

} // namespace

DrawRenderer::~DrawRenderer() {
  if (!m_process)
    return;
  m_process->disconnect(this);
  m_process->kill();
  m_process->waitForFinished(1000);
}

void DrawRenderer::start(const RenderOptions &options, const QString &) { m_options = options; }

void DrawRenderer::kill() {
  if (m_process)
    m_process->kill();
}

void DrawRenderer::draw(const Scene &scene) {
  m_scene = scene;
  const QString document = layOut(scene, m_folder.path());
  m_process = new QProcess(this);
  const pid_t parent = ::getpid();
  m_process->setChildProcessModifier([parent] {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent)
      ::_exit(1);
  });
  m_process->setWorkingDirectory(m_folder.path());
  m_process->setStandardOutputFile(QProcess::nullDevice());
  connect(m_process, &QProcess::finished, this, &DrawRenderer::finished);
  connect(m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart)
      finished(127, QProcess::NormalExit);
  });
  m_since.start();
  m_process->start(m_program,
                   argumentsOf(m_options, document, m_folder.filePath(QStringLiteral("out.png"))));
}

void DrawRenderer::finished(int code, QProcess::ExitStatus status) {
  const QString complaint = QString::fromLocal8Bit(m_process->readAllStandardError()).trimmed();
  m_process->disconnect(this);
  m_process->deleteLater();
  m_process = nullptr;
  if (status == QProcess::CrashExit)
    return Q_EMIT ended(tr("drawing was stopped by a signal"));
  SceneAnswer answer;
  answer.revision = m_scene.revision;
  answer.milliseconds = double(m_since.elapsed());
  const QString file = m_folder.filePath(QStringLiteral("out.png"));
  QImage image;
  answer.ok = code == 0 && image.load(file);
  QFile::remove(file);
  if (!answer.ok) {
    const QString message = complaint.isEmpty() ? tr("`arbiter draw` ended with code %1").arg(code)
                                                : complaint.section(u'\n', 0, 0);
    // The language server already reports the diagnostics of an invalid program, with their places.
    if (code != kExitInvalid)
      answer.problems.append({Severity::Error,
                              QStringLiteral("draw"),
                              message,
                              complaint.section(u'\n', 1),
                              {},
                              0,
                              0});
  } else {
    Q_EMIT drew({image.convertToFormat(QImage::Format_RGBA8888), answer.revision, 0, 0,
                 answer.milliseconds, 0});
  }
  Q_EMIT answered(answer);
}

} // namespace arbiter::builder
