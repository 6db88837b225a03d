#pragma once
#include <QObject>
#include <QTimer>

#include "builder/model/text/document.h"
#include "builder/model/text/file_watch.h"
#include "builder/model/text/journal.h"
#include "builder/model/text/text_file.h"

namespace arbiter::builder {

/// A document with its file: opened, journalled, saved, watched.
class OpenFile : public QObject {
  Q_OBJECT
public:
  /// \param journals the folder of journals
  explicit OpenFile(const QString &journals, QObject *parent = nullptr);
  ~OpenFile() override;

  [[nodiscard]] Document &document() { return m_document; }
  [[nodiscard]] const Document &document() const { return m_document; }
  /// Absolute; empty of a document that was never saved.
  [[nodiscard]] const QString &path() const { return m_path; }
  /// "twirl.fp", or "untitled".
  [[nodiscard]] QString name() const;
  /// The file's name; of a text that was never saved the one that it may have: that of the document
  /// it is a copy of, or "untitled.fp".
  [[nodiscard]] QString proposedName() const;
  /// Where relative names in the text lead from.
  [[nodiscard]] QString folder() const;

  [[nodiscard]] Result<QString, FileFault> open(const QString &path);
  /// A text without a file; \p folder is where it looks for what it names, \p proposed the name
  /// that it may be saved as.
  void openText(const QString &text, const QString &folder = {}, const QString &proposed = {});
  /// What a journal kept: the file's text if there is one, then the kept one as an undo step.
  void recover(const Recovered &recovered);
  /// Writes to the file, or to another, which is the document's from then on.
  [[nodiscard]] Result<QString, FileFault> save(const QString &path = {});

  /// Of a conflict: the file's text replaces the document's, as one undo step.
  void takeTheirs(const QString &theirs);
  /// Of a conflict: the document stays; saving it replaces the file's text.
  void keepMine(const QString &theirs) { m_document.setSavedText(theirs); }

Q_SIGNALS:
  void pathChanged(const QString &path);
  /// The file was changed elsewhere, and what it changed is in the document now.
  void merged(int changedLines);
  /// Both changed the same lines: the document is as it was; the file has this text.
  void conflict(const QString &theirs);
  void fileRemoved();
  /// Something was not kept or read; the text says what.
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
  bool m_opening = false;  ///< what changes now is no edit
};

} // namespace arbiter::builder
