#pragma once
#include <QByteArray>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace arbiter::builder {

/// Reports that another program changed a file, in place or by replacing it, as most editors do.
class FileWatch : public QObject {
  Q_OBJECT
public:
  explicit FileWatch(QObject *parent = nullptr);

  /// Watches a file instead of the previous one; none if empty.
  void watch(const QString &path);
  /// Sets the bytes that the file is known to hold; a change to these bytes is not reported.
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
  QTimer m_settle; ///< gives writers a moment to finish
};

} // namespace arbiter::builder
