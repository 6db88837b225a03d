#pragma once
#include <QList>
#include <QString>

#include "apps/builder/model/text/edit.h"
#include "apps/builder/model/text/text_file.h"

namespace arbiter::builder {

/// A document that a process left unsaved when it ended.
struct Recovered {
  QString journal; ///< the file to remove after it is taken or refused
  QString path;    ///< of the document; empty if untitled
  QString text;
};

/// Writes every edit of a document to a file before the next one, so that the text survives any end
/// of the process. Each line is JSON: first the document's path and text, then the edits. An
/// incomplete last line is ignored. A lock, which ends with the process, marks journals in use.
class Journal {
public:
  /// \param folder of all journals; created when needed, for the user alone
  explicit Journal(QString folder) : m_folder(std::move(folder)) {}
  Journal(const Journal &) = delete;
  Journal &operator=(const Journal &) = delete;
  ~Journal() { close(); }

  /// Starts a new journal with a text. \error the folder or file cannot be written
  [[nodiscard]] Result<QString, FileFault> begin(const QString &path, const QString &text);
  /// Appends an edit. \returns false if it could not be written: the disk is full, or begin()
  /// failed
  bool record(const Edit &edit);
  /// Flushes to the disk, against a loss of power; records survive the process anyway.
  void sync() const;
  /// Removes the journal, as the document is closed or has no change.
  void close();
  [[nodiscard]] qint64 bytes() const { return m_bytes; }

  /// Returns the documents of processes that have ended. Ignores unreadable journals.
  [[nodiscard]] static QList<Recovered> recoverable(const QString &folder);
  static void discard(const Recovered &recovered);

private:
  [[nodiscard]] bool write(const QByteArray &line);

  QString m_folder;
  QString m_file;
  qint64 m_bytes = 0;
  int m_descriptor = -1;
};

} // namespace arbiter::builder
