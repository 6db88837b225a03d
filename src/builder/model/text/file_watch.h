#pragma once
#include <QByteArray>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace arbiter::builder {

/// Says when another program changed a file: written in place, or replaced by another file of its
/// name, as most editors save.
class FileWatch : public QObject {
  Q_OBJECT
public:
  explicit FileWatch(QObject *parent = nullptr);

  /// Watches one file, in place of the last; none if empty.
  void watch(const QString &path);
  /// What the file is known to hold: a change to these bytes is not told.
  void setKnown(const QByteArray &bytes) { m_known = bytes; }

Q_SIGNALS:
  void changed(const QByteArray &bytes);
  void removed();

private:
  void look();
  void arm();

  QString m_path;
  QByteArray m_known;
  bool m_gone = false;
  QFileSystemWatcher m_watcher;
  QTimer m_settle; ///< writers are given a moment to finish
};

} // namespace arbiter::builder
