#include "apps/builder/model/panels/companions.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "apps/scene/document.h"
#include "fp_compiler/hw/profile.h"

namespace arbiter::builder {

namespace {

/// Adds a name. A name that leaves the folder is an error of its line, and not a file of the
/// document.
void add(const scene::Name &name, QStringList &names) {
  const QString text = QString::fromStdString(name.text);
  const bool leaves =
      QDir::isAbsolutePath(text) || QDir::cleanPath(text).startsWith(QStringLiteral(".."));
  if (!text.isEmpty() && !leaves && !names.contains(text))
    names << text;
}

void addImages(const scene::TextureSource &source, QStringList &names) {
  for (const scene::Name &file : source.files)
    add(file, names);
  for (const scene::TextureSource &inner : source.of)
    addImages(inner, names);
}

void addShape(const scene::ShapeSpec &shape, QStringList &names) {
  add(shape.file, names);
  for (const scene::ShapeSpec &inner : shape.of)
    addShape(inner, names);
}

void addPanel(const scene::Panel &panel, QStringList &names) {
  if (fp::hw::isProfileFile(panel.profile.text))
    add(panel.profile, names);
  add(panel.vertex, names);
  for (const scene::Name &name : panel.then)
    add(name, names);
  for (const scene::TextureSpec &texture : panel.textures)
    addImages(texture.source, names);
  for (const scene::ShapeSpec &shape : panel.mesh)
    addShape(shape, names);
}

} // namespace

QStringList companionsOf(const QString &text, const QString &name, const QString &folder) {
  const std::string path = QDir(folder).filePath(name).toStdString();
  const scene::Document document = scene::assemble(path, text.toStdString(), scene::readText);
  QStringList names;
  for (const scene::ProgramFile &file : document.files)
    addPanel(file.panel, names);
  return names;
}

QStringList copyCompanions(const QStringList &names, const QString &from, const QString &to,
                           QStringList &failed) {
  QStringList copied;
  const QDir source(from), target(to);
  for (const QString &name : names) {
    if (!source.exists(name) || target.exists(name))
      continue;
    const QString path = target.filePath(name);
    if (target.mkpath(QFileInfo(path).path()) && QFile::copy(source.filePath(name), path)) {
      // An installed file may be read-only; the copy belongs to the user.
      QFile::setPermissions(path, QFile::permissions(path) | QFile::WriteOwner);
      copied << name;
    } else {
      failed << name;
    }
  }
  return copied;
}

} // namespace arbiter::builder
