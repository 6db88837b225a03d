#include "apps/builder/model/panels/tool_run.h"

#include <QJsonDocument>
#include <QRegularExpression>

#include "apps/builder/model/render/work_folder.h"

namespace arbiter::builder {

namespace {
constexpr int kRunMilliseconds = 60000;
}

QJsonObject ToolResult::json() const { return QJsonDocument::fromJson(output).object(); }

ToolRun::ToolRun(QString program, QObject *parent)
    : QObject(parent), m_program(std::move(program)) {
  m_patience.setSingleShot(true);
  m_patience.setInterval(kRunMilliseconds);
  connect(&m_patience, &QTimer::timeout, this, [this] { finish(false); });
}

ToolRun::~ToolRun() { cancel(); }

void ToolRun::cancel() {
  m_patience.stop();
  if (!m_process)
    return;
  m_process->disconnect(this);
  m_process->kill();
  m_process->waitForFinished(1000);
  m_process->deleteLater();
  m_process = nullptr;
}

void ToolRun::run(const QStringList &arguments, const Scene &scene, Done done) {
  cancel();
  m_done = std::move(done);
  m_output.clear();
  QStringList words = arguments;
  m_process = new QProcess(this);
  if (words.contains(QStringLiteral("@"))) {
    m_folder = std::make_unique<QTemporaryDir>();
    words.replaceInStrings(QRegularExpression(QStringLiteral("^@$")),
                           layOut(scene, m_folder->path()));
    m_process->setWorkingDirectory(m_folder->path());
  }
  connect(m_process, &QProcess::readyReadStandardOutput, this, [this] {
    m_output += m_process->readAllStandardOutput();
    if (m_output.size() > kMaxOutput)
      finish(false);
  });
  connect(m_process, &QProcess::finished, this,
          [this](int, QProcess::ExitStatus status) { finish(status == QProcess::NormalExit); });
  connect(m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart)
      finish(false);
  });
  m_process->start(m_program, words, QIODevice::ReadOnly);
  m_patience.start();
}

void ToolRun::finish(bool finished) {
  if (!m_process)
    return;
  ToolResult result;
  result.started = m_process->error() != QProcess::FailedToStart;
  result.finished = finished;
  if (result.started && finished) {
    m_output += m_process->readAllStandardOutput();
    result.code = m_process->exitCode();
  }
  result.output = m_output;
  result.complaint = QString::fromLocal8Bit(m_process->readAllStandardError()).trimmed();
  m_process->disconnect(this);
  m_process->kill();
  m_process->deleteLater();
  m_process = nullptr;
  m_patience.stop();
  if (const Done done = std::exchange(m_done, {}))
    done(result);
}

} // namespace arbiter::builder
