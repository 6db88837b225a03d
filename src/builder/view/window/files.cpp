// Documents opened, saved and recovered.
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "builder/view/editor/code_editor.h"
#include "builder/view/window/export_dialog.h"
#include "builder/view/window/main_window.h"

namespace arbiter::builder {

namespace {

constexpr const char *kNewText = "!!ARBfp1.0\n"
                                 "#@ size 512 512, mesh quad\n"
                                 "MOV result.color, fragment.texcoord[0];\n"
                                 "END\n";

QString filter() { return QObject::tr("Programs (*.fp *.vp *.atifs);;All files (*)"); }

/// The document of a folder: the file of its name, else main.fp, else its first program.
QString documentOf(const QString &folder) {
  const QDir dir(folder);
  for (const QString &name : {dir.dirName() + QStringLiteral(".fp"), QStringLiteral("main.fp")})
    if (dir.exists(name))
      return dir.filePath(name);
  const QStringList all = dir.entryList({QStringLiteral("*.fp")}, QDir::Files);
  return all.isEmpty() ? QString() : dir.filePath(all.first());
}

} // namespace

void MainWindow::openPath(const QString &path) {
  const QString file = QFileInfo(path).isDir() ? documentOf(path) : path;
  if (file.isEmpty()) {
    notice(tr("%1: no program (*.fp) in this folder").arg(path));
    return;
  }
  const auto opened = m_bench.file().open(file);
  if (!opened)
    notice(opened.error().message);
}

void MainWindow::openNamed(const QString &name) {
  const QString scheme = QStringLiteral("gallery:");
  if (!name.startsWith(scheme))
    return openPath(name);
  openCopy(QStringLiteral("%1/%2.fp").arg(m_bench.places().gallery, name.mid(scheme.size())));
}

void MainWindow::openText(const QString &text) { m_bench.file().openText(text); }

void MainWindow::newFile() {
  if (!mayDiscard())
    return;
  openText(QString::fromLatin1(kNewText));
  m_editor->setFocus();
}

void MainWindow::openFile() {
  if (!mayDiscard())
    return;
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Open"), m_bench.file().folder(), filter());
  if (!path.isEmpty())
    openPath(path);
}

/// A document of the gallery is opened as a text without a name, so that it stays as it is.
void MainWindow::openCopy(const QString &path) {
  if (!mayDiscard())
    return;
  const auto file = readText(path);
  if (!file)
    return notice(file.error().message);
  m_bench.file().openText(file.value().text, QFileInfo(path).absolutePath());
  showPanel(tr("Program"));
}

bool MainWindow::save() {
  if (m_bench.file().path().isEmpty())
    return saveAs();
  const auto saved = m_bench.file().save();
  notice(saved ? tr("%1 is saved").arg(saved.value()) : saved.error().message);
  return saved.ok();
}

bool MainWindow::saveAs() {
  const QString path =
      QFileDialog::getSaveFileName(this, tr("Save as"), m_bench.file().folder(), filter());
  if (path.isEmpty())
    return false;
  const auto saved = m_bench.file().save(path);
  notice(saved ? tr("%1 is saved").arg(saved.value()) : saved.error().message);
  return saved.ok();
}

bool MainWindow::mayDiscard() {
  if (!m_bench.document().isModified())
    return true;
  const auto answer = QMessageBox::question(
      this, tr("Unsaved changes"),
      tr("%1 has changes that are not saved.").arg(m_bench.file().name()),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save)
    return save();
  return answer == QMessageBox::Discard;
}

void MainWindow::exportPicture() {
  if (m_bench.picture().isNull())
    return notice(tr("there is no picture to export yet"));
  const QString path = QFileDialog::getSaveFileName(this, tr("Export picture"),
                                                    m_bench.file().folder(), tr("PNG (*.png)"));
  if (!path.isEmpty())
    notice(m_bench.picture().save(path, "PNG") ? tr("%1 is written").arg(path)
                                               : tr("%1 cannot be written").arg(path));
}

void MainWindow::exportSequence() {
  ExportDialog dialog(m_bench, this);
  dialog.exec();
}

void MainWindow::openInstead(const QString &path) {
  if (!mayDiscard())
    return;
  openPath(path);
  showPanel(tr("Program"));
}

void MainWindow::askConflict(const QString &theirs) {
  QMessageBox box(
      QMessageBox::Warning, tr("Changed twice"),
      tr("Another program changed the same lines of %1 as you did.").arg(m_bench.file().name()),
      QMessageBox::NoButton, this);
  QAbstractButton *mine = box.addButton(tr("&Keep mine"), QMessageBox::AcceptRole);
  QAbstractButton *other = box.addButton(tr("&Take the file's"), QMessageBox::DestructiveRole);
  box.setDefaultButton(qobject_cast<QPushButton *>(mine));
  box.exec();
  if (box.clickedButton() == other)
    m_bench.file().takeTheirs(theirs); // Ctrl+Z gives mine back
  else
    m_bench.file().keepMine(theirs);
}

void MainWindow::offerRecovery() {
  for (const Recovered &recovered : Journal::recoverable(m_bench.places().journals)) {
    const QString name = recovered.path.isEmpty() ? tr("a text without a name") : recovered.path;
    const auto answer = QMessageBox::question(
        this, tr("Unsaved text"),
        tr("The builder ended without saving %1. Take up the text where it was?").arg(name),
        QMessageBox::Yes | QMessageBox::Discard, QMessageBox::Yes);
    if (answer != QMessageBox::Yes) {
      Journal::discard(recovered);
      continue;
    }
    m_bench.file().recover(recovered);
    return; // the next one, when this window is closed and another opened
  }
}

} // namespace arbiter::builder
