#pragma once
#include <QObject>
#include <QTimer>

#include "apps/builder/model/text/document.h"
#include "apps/builder/model/text/file_watch.h"
#include "apps/builder/model/text/journal.h"
#include "apps/builder/model/text/text_file.h"

namespace arbiter::builder {

/// A document with its file, which it opens, journals, saves and watches.
class OpenFile : public QObject {
  Q_OBJECT
public:
  /// \param journals the folder of journals
  explicit OpenFile(const QString &journals, QObject *parent = nullptr);
  ~OpenFile() override;

  [[nodiscard]] Document &document() { return m_document; }
  [[nodiscard]] const Document &document() const { return m_document; }
  /// Returns the absolute path; empty if the document was never saved.
  [[nodiscard]] const QString &path() const { return m_path; }
  /// Returns "twirl.fp", or "untitled".
  [[nodiscard]] QString name() const;
  /// Returns the file's name. For a text that was never saved it is a proposal: the name of the
  /// document that it copies, or "untitled.fp".
  [[nodiscard]] QString proposedName() const;
  /// Returns the folder that relative names in the text start from.
  [[nodiscard]] QString folder() const;

  [[nodiscard]] Result<QString, FileFault> open(const QString &path);
  /// Opens a text without a file. \p folder is where it looks for the files it names, \p proposed
  /// the name that it may be saved as.
  void openText(const QString &text, const QString &folder = {}, const QString &proposed = {});
  /// Restores a journal's document: the file's text if there is one, then the journal's text as an
  /// undo step.
  void recover(const Recovered &recovered);
  /// Writes to the file, or to another, which then becomes the document's.
  [[nodiscard]] Result<QString, FileFault> save(const QString &path = {});

  /// Resolves a conflict: the file's text replaces the document's, as one undo step.
  void takeTheirs(const QString &theirs);
  /// Resolves a conflict: the document stays, and saving it replaces the file's text.
  void keepMine(const QString &theirs) { m_document.setSavedText(theirs); }

Q_SIGNALS:
  void pathChanged(const QString &path);
  /// Reports that the file was changed elsewhere, and that the document now contains the change.
  void merged(int changedLines);
  /// Reports that both changed the same lines. The document is unchanged; the file has this text.
  void conflict(const QString &theirs);
  void fileRemoved();
  /// Reports that something could not be kept or read.
  void complaint(const QString &message);

private:
  void begin(const QString &path, const TextFile &file);
  void journal(const Edit &edit);
  void outsideChange(const QByteArray &bytes);

  Document m_document;
  Journal m_journal;
  FileWatch m_watch;
  QTimer m_sync;
  TextFormat m_format;
  QString m_path;
  QString m_folder;
  QString m_proposed;
  bool m_journals = false; ///< the journal has begun for this text
  bool m_opening = false;  ///< present changes are not edits
};

} // namespace arbiter::builder
