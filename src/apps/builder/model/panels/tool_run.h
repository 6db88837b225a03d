#pragma once
#include <QByteArray>
#include <QJsonObject>
#include <QObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimer>
#include <functional>
#include <memory>

#include "apps/builder/model/render/renderer.h"

namespace arbiter::builder {

/// The result of a command of `arbiter`.
struct ToolResult {
  bool started = false;
  bool finished = false; ///< exited by itself, not by a signal or timeout
  int code = -1;
  QByteArray output;
  QString complaint; ///< standard error

  /// Returns the document on standard output; empty if it is not JSON.
  [[nodiscard]] QJsonObject json() const;
};

/// Runs one command of `arbiter` at a time in a process; a new one replaces a running one. A
/// command that takes too long or writes too much is killed.
class ToolRun : public QObject {
  Q_OBJECT
public:
  static constexpr qsizetype kMaxOutput = 64 << 20;

  explicit ToolRun(QString program, QObject *parent = nullptr);
  ~ToolRun() override;

  using Done = std::function<void(const ToolResult &)>;
  /// Runs a command. \param arguments "@" stands for the path of the scene's text, which is written
  /// with the files beside it
  void run(const QStringList &arguments, const Scene &scene, Done done);
  void cancel();
  [[nodiscard]] bool isRunning() const { return m_process != nullptr; }
  void setPatience(int milliseconds) { m_patience.setInterval(milliseconds); }

private:
  void finish(bool finished);

  QString m_program;
  QProcess *m_process = nullptr;
  std::unique_ptr<QTemporaryDir> m_folder;
  QByteArray m_output;
  Done m_done;
  QTimer m_patience;
};

} // namespace arbiter::builder
