// Opens, saves and recovers documents.
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

#include "apps/builder/model/panels/companions.h"
#include "apps/builder/view/editor/code_editor.h"
#include "apps/builder/view/window/export_dialog.h"
#include "apps/builder/view/window/main_window.h"

namespace arbiter::builder {

namespace {

constexpr const char *kNewText = "!!ARBfp1.0\n"
                                 "#@ size 512 512, mesh quad\n"
                                 "MOV result.color, fragment.texcoord[0];\n"
                                 "END\n";

QString filter() {
  return QObject::tr("Programs (*.fp *.vp *.atifs *.nvrc *.nvts);;All files (*)");
}

/// Returns the document of a folder: the file of its name, else main.fp, else its first program.
QString documentOf(const QString &folder) {
  const QDir dir(folder);
  for (const QString &name : {dir.dirName() + QStringLiteral(".fp"), QStringLiteral("main.fp")})
    if (dir.exists(name))
      return dir.filePath(name);
  const QStringList all = dir.entryList({QStringLiteral("*.fp")}, QDir::Files);
  return all.isEmpty() ? QString() : dir.filePath(all.first());
}

bool isWritableFolder(const QString &folder) {
  const QFileInfo info(folder);
  return !folder.isEmpty() && info.isDir() && info.isWritable();
}

const QString kFolderKey = QStringLiteral("folder");

/// Stores the folder of a file that the user chose, where the next dialog begins.
void rememberFolderOf(const QString &file) {
  QSettings().setValue(kFolderKey, QFileInfo(file).absolutePath());
}

} // namespace

/// Returns the document's own folder, unless it is a copy of an installed one; then the user's last
/// or present folder.
QString MainWindow::userFolder() {
  QStringList places;
  if (!m_bench.file().path().isEmpty())
    places << m_bench.file().folder();
  places << QSettings().value(kFolderKey).toString() << QDir::currentPath();
  for (const QString &place : places)
    if (isWritableFolder(place))
      return place;
  return QDir::homePath();
}

bool MainWindow::openPath(const QString &path) {
  const QString file = QFileInfo(path).isDir() ? documentOf(path) : path;
  if (file.isEmpty()) {
    notice(tr("%1: no program (*.fp) in this folder").arg(path));
    return false;
  }
  const auto opened = m_bench.file().open(file);
  if (!opened)
    notice(opened.error().message);
  return opened.ok();
}

bool MainWindow::openNamed(const QString &name) {
  const QString scheme = QStringLiteral("gallery:");
  if (!name.startsWith(scheme))
    return openPath(name);
  return openCopy(
      QStringLiteral("%1/%2.fp").arg(m_bench.places().gallery, name.mid(scheme.size())));
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
  const QString path = QFileDialog::getOpenFileName(this, tr("Open"), userFolder(), filter());
  if (!path.isEmpty() && openPath(path))
    rememberFolderOf(path);
}

/// Opens a document of the gallery as an untitled text, so that the original stays.
bool MainWindow::openCopy(const QString &path) {
  if (!mayDiscard())
    return false;
  const auto file = readText(path);
  if (!file) {
    notice(file.error().message);
    return false;
  }
  const QFileInfo info(path);
  m_bench.file().openText(file.value().text, info.absolutePath(), info.fileName());
  showPanel(tr("Program"));
  return true;
}

bool MainWindow::save() {
  if (m_bench.file().path().isEmpty())
    return saveAs();
  const auto saved = m_bench.file().save();
  notice(saved ? tr("%1 is saved").arg(saved.value()) : saved.error().message);
  return saved.ok();
}

bool MainWindow::saveAs() {
  const QString proposed = QDir(userFolder()).filePath(m_bench.file().proposedName());
  const QString path = QFileDialog::getSaveFileName(this, tr("Save as"), proposed, filter());
  if (path.isEmpty())
    return false;
  const QString beside = takeCompanions(QFileInfo(path).absolutePath());
  const auto saved = m_bench.file().save(path);
  if (saved)
    rememberFolderOf(path);
  notice((saved ? tr("%1 is saved").arg(saved.value()) : saved.error().message) + beside);
  return saved.ok();
}

/// Copies the files that the document names to another folder. This comes before saving, so that
/// programs that read the document there find them. \returns a message about it
QString MainWindow::takeCompanions(const QString &folder) {
  OpenFile &file = m_bench.file();
  if (QDir(folder) == QDir(file.folder()))
    return {};
  QStringList failed;
  const QStringList names =
      companionsOf(file.document().text(), file.proposedName(), file.folder());
  const QStringList copied = copyCompanions(names, file.folder(), folder, failed);
  QString said;
  if (!copied.isEmpty())
    said += tr(", and beside it %1, which it names").arg(copied.join(QStringLiteral(", ")));
  if (!failed.isEmpty())
    said += tr("; copy %1 there, which it names").arg(failed.join(QStringLiteral(", ")));
  return said;
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
  const QString name = QFileInfo(m_bench.file().proposedName()).completeBaseName();
  const QString proposed = QDir(userFolder()).filePath(name + QStringLiteral(".png"));
  const QString path =
      QFileDialog::getSaveFileName(this, tr("Export picture"), proposed, tr("PNG (*.png)"));
  if (path.isEmpty())
    return;
  const bool written = m_bench.picture().save(path, "PNG");
  if (written)
    rememberFolderOf(path);
  notice(written ? tr("%1 is written").arg(path) : tr("%1 cannot be written").arg(path));
}

void MainWindow::exportSequence() {
  ExportDialog dialog(m_bench, userFolder(), this);
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
    m_bench.file().takeTheirs(theirs); // Ctrl+Z restores mine
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
    return; // recovers the next one after this window is closed and another opened
  }
}

} // namespace arbiter::builder
