#include "apps/builder/model/text/file_watch.h"

#include <QFile>
#include <QFileInfo>

#include "apps/builder/model/text/text_file.h"

namespace arbiter::builder {

namespace {
constexpr int kSettleMilliseconds = 40;
}

FileWatch::FileWatch(QObject *parent) : QObject(parent) {
  m_settle.setSingleShot(true);
  m_settle.setInterval(kSettleMilliseconds);
  connect(&m_settle, &QTimer::timeout, this, &FileWatch::look);
  const auto settle = [this] { m_settle.start(); };
  connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, settle);
  connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, settle);
}

void FileWatch::watch(const QString &path) {
  if (const QStringList all = m_watcher.files() + m_watcher.directories(); !all.isEmpty())
    m_watcher.removePaths(all);
  m_path = path;
  m_gone = false;
  arm();
}

/// Watches the file and its folder again. The watcher forgets a file that was replaced, but not its
/// folder.
void FileWatch::arm() {
  if (m_path.isEmpty())
    return;
  if (!m_watcher.files().contains(m_path) && QFileInfo::exists(m_path))
    m_watcher.addPath(m_path);
  const QString folder = QFileInfo(m_path).absolutePath();
  if (!m_watcher.directories().contains(folder))
    m_watcher.addPath(folder);
}

void FileWatch::look() {
  if (m_path.isEmpty())
    return;
  arm();
  QFile file(m_path);
  if (!file.open(QIODevice::ReadOnly)) {
    if (!m_gone && !file.exists())
      Q_EMIT removed();
    m_gone = true;
    return;
  }
  m_gone = false;
  const QByteArray bytes = readAtMost(file, kMaxTextBytes);
  if (bytes == m_known)
    return;
  m_known = bytes;
  Q_EMIT changed(bytes);
}

} // namespace arbiter::builder
