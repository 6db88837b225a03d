#pragma once
#include <QList>
#include <QString>

#include "builder/model/text/edit.h"
#include "builder/model/text/text_file.h"

namespace arbiter::builder {

/// What a process that ended without closing a document left behind.
struct Recovered {
  QString journal; ///< the file to remove when it is taken or refused
  QString path;    ///< of the document; empty if it had none yet
  QString text;
};

/// Every edit of a document, in a file, before the next one is made: whatever ends the process, the
/// text is there again. A line each of JSON: the document's path and text, then edits. A torn last
/// line is passed over. A lock that ends with the process tells the journals of living ones.
class Journal {
public:
  /// \param folder of all journals; made, for the user alone, when it is needed
  explicit Journal(QString folder) : m_folder(std::move(folder)) {}
  Journal(const Journal &) = delete;
  Journal &operator=(const Journal &) = delete;
  ~Journal() { close(); }

  /// Begins anew with a text. \error the folder or file cannot be written
  [[nodiscard]] Result<QString, FileFault> begin(const QString &path, const QString &text);
  /// \returns false if it could not be written: the disk is full, or begin() failed
  bool record(const Edit &edit);
  /// To the disk, for a machine that loses its power; what is recorded outlives the process anyway.
  void sync() const;
  /// The document is closed or has no change: the journal goes.
  void close();
  [[nodiscard]] qint64 bytes() const { return m_bytes; }

  /// Of processes that are no more. Unreadable ones are left alone.
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
