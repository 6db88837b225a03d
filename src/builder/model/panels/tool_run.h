#pragma once
#include <QByteArray>
#include <QJsonObject>
#include <QObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimer>
#include <functional>
#include <memory>

#include "builder/model/render/renderer.h"

namespace arbiter::builder {

/// What a command of `arbiter` left.
struct ToolResult {
  bool started = false;
  bool finished = false; ///< by itself, not by a signal or for lack of time
  int code = -1;
  QByteArray output;
  QString complaint; ///< standard error

  /// The document on standard output; empty if it is none.
  [[nodiscard]] QJsonObject json() const;
};

/// One command of `arbiter` at a time, in a process of its own: a new one takes the place of one
/// that runs. One that takes too long, or writes too much, is ended.
class ToolRun : public QObject {
  Q_OBJECT
public:
  static constexpr qsizetype kMaxOutput = 64 << 20;

  explicit ToolRun(QString program, QObject *parent = nullptr);
  ~ToolRun() override;

  using Done = std::function<void(const ToolResult &)>;
  /// \param arguments "@" among them stands for the path of the scene's text, laid out with what
  /// lies beside it
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
