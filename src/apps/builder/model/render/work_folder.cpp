#include "apps/builder/model/render/work_folder.h"

#include <QDir>
#include <QFile>

namespace arbiter::builder {

namespace {

/// At most this many entries of a folder are linked; no document has so many files.
constexpr int kMaxLinks = 2000;

void write(const QString &path, const QString &text) {
  QFile::remove(path); // a link's target must not be overwritten
  QFile file(path);
  if (file.open(QIODevice::WriteOnly | QIODevice::NewOnly))
    file.write(text.toUtf8());
}

} // namespace

QString layOut(const Scene &scene, const QString &folder) {
  const QDir source(scene.folder.isEmpty() ? QDir::currentPath() : scene.folder);
  const QDir target(folder);
  int links = 0;
  for (const QFileInfo &entry :
       source.entryInfoList(QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QString name = target.filePath(entry.fileName());
    if (!QFileInfo::exists(name) && ++links <= kMaxLinks)
      QFile::link(entry.absoluteFilePath(), name);
  }
  for (auto file = scene.files.cbegin(); file != scene.files.cend(); ++file)
    if (!file.key().contains(u'/'))
      write(target.filePath(file.key()), file.value());
  const QString name = scene.name.isEmpty() ? QStringLiteral("untitled.fp") : scene.name;
  QString path = target.filePath(QFileInfo(name).fileName());
  write(path, scene.text);
  return path;
}

} // namespace arbiter::builder
