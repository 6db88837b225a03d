#pragma once
#include <QElapsedTimer>
#include <QList>
#include <QObject>

#include "apps/builder/model/text/edit.h"

namespace arbiter::builder {

/// The origin of an edit.
enum class Origin {
  Typing,  ///< the editor's keys; adjacent edits become one undo step
  Tool,    ///< a slider, a fix, a rename: each is an undo step
  Outside, ///< another program has changed the file: an undo step
  History, ///< undo and redo
};

/// The edited text with its undo history. It is the only place of undo: editors display it and send
/// it their edits, so that the same keys undo the changes of sliders and other programs.
class Document : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  [[nodiscard]] const QString &text() const { return m_text; }
  /// Increases with every change; texts with one number are equal.
  [[nodiscard]] qint64 revision() const { return m_revision; }
  /// True if the text differs from the one that was last opened or saved.
  [[nodiscard]] bool isModified() const { return m_text != m_saved; }
  /// Returns the text as it was last opened or saved.
  [[nodiscard]] const QString &savedText() const { return m_saved; }

  /// Takes a text from a file and clears the undo history.
  void open(const QString &text);
  /// Marks the present text as the file's.
  void markSaved();
  /// Sets the file's text, which may differ from the document's after a merge.
  void setSavedText(const QString &text);

  /// Replaces a piece, which is clipped to the text.
  /// \param name the name of the undo step ("Move magnitude"); typing needs none
  void replace(qsizetype at, qsizetype length, const QString &added, Origin origin,
               const QString &name = {});
  /// Replaces the whole text by the smallest edit, as one step.
  void become(const QString &text, Origin origin, const QString &name);
  /// Makes several edits, each in the text left by the ones before, as one undo step.
  void apply(const QList<Edit> &edits, const QString &name);

  [[nodiscard]] bool canUndo() const { return m_done > 0; }
  [[nodiscard]] bool canRedo() const { return m_done < m_steps.size(); }
  [[nodiscard]] QString undoName() const {
    return canUndo() ? m_steps[m_done - 1].name : QString();
  }
  [[nodiscard]] QString redoName() const { return canRedo() ? m_steps[m_done].name : QString(); }
  void undo();
  void redo();
  /// Ends the present undo step of typing.
  void closeStep() { m_open = false; }

Q_SIGNALS:
  /// Reports each edit; text() already contains it.
  void edited(const arbiter::builder::Edit &edit, arbiter::builder::Origin origin);
  /// Reports a step, undo, redo, save or open.
  void stateChanged();

private:
  struct Step {
    QList<Edit> edits;
    QString name;
  };

  void perform(const Edit &edit, Origin origin);
  void record(const Edit &edit, Origin origin, const QString &name);
  [[nodiscard]] bool joins(const Edit &edit) const;

  QString m_text;
  QString m_saved;
  qint64 m_revision = 0;
  QList<Step> m_steps;
  qsizetype m_done = 0; ///< number of steps that are not undone
  bool m_open = false;  ///< the last step is typing that may continue
  QElapsedTimer m_sinceTyping;
};

} // namespace arbiter::builder
