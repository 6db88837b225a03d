#include "apps/builder/view/panels/beside.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMessageBox>

namespace arbiter::builder {

namespace {

/// Returns a file name that is free there: "photo.png", "photo-2.png".
QString freeName(const QDir &folder, const QString &path) {
  const QFileInfo file(path);
  QString name = file.fileName();
  for (int number = 2; folder.exists(name); ++number)
    name = QStringLiteral("%1-%2.%3").arg(file.completeBaseName()).arg(number).arg(file.suffix());
  return name;
}

} // namespace

QString copyBeside(Workbench &bench, const QString &path) {
  const QDir folder(bench.file().folder());
  QString name = freeName(folder, path);
  if (QFile::copy(path, folder.filePath(name)))
    return name;
  Q_EMIT bench.notice(QObject::tr("%1 cannot be copied into %2: put it there yourself, or save the "
                                  "document where you may write")
                          .arg(QFileInfo(path).fileName(), folder.path()));
  return {};
}

QString nameBeside(QWidget *parent, Workbench &bench, const QString &path) {
  const QDir folder(bench.file().folder());
  QString relative = folder.relativeFilePath(path);
  if (!relative.startsWith(u"..") && !QDir::isAbsolutePath(relative))
    return relative;
  const auto answer = QMessageBox::question(
      parent, QObject::tr("Another folder"),
      QObject::tr("A document's files lie beside it or in folders below. Copy %1 into %2?")
          .arg(QFileInfo(path).fileName(), folder.path()));
  return answer == QMessageBox::Yes ? copyBeside(bench, path) : QString();
}

} // namespace arbiter::builder
