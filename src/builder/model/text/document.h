#pragma once
#include <QElapsedTimer>
#include <QList>
#include <QObject>

#include "builder/model/text/edit.h"

namespace arbiter::builder {

/// Who changed a text.
enum class Origin {
  Typing,  ///< the editor's keys; neighbouring ones become one undo step
  Tool,    ///< a slider, a fix, a rename: an undo step each
  Outside, ///< the file, changed by another program: an undo step
  History, ///< undo and redo
};

/// The text that is edited, and all that was done to it. The one place of undo: editors show it and
/// send what is typed here, so that what a slider or another program changes is undone by the same
/// keys.
class Document : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  [[nodiscard]] const QString &text() const { return m_text; }
  /// Grows with every change; a text has the same number only if it is the same text.
  [[nodiscard]] qint64 revision() const { return m_revision; }
  /// True if the text is not the one that was last opened or saved.
  [[nodiscard]] bool isModified() const { return m_text != m_saved; }
  /// The text as it was last opened or saved.
  [[nodiscard]] const QString &savedText() const { return m_saved; }

  /// Takes a text as opened from a file: no undo leads behind it.
  void open(const QString &text);
  /// The text stands in the file now.
  void markSaved();
  /// The file has this text now, the document may have another (after a merge).
  void setSavedText(const QString &text);

  /// Replaces a piece. Pieces beyond the text's end are cut to it.
  /// \param name what the undo step is called ("Move magnitude"); typing needs none
  void replace(qsizetype at, qsizetype length, const QString &added, Origin origin,
               const QString &name = {});
  /// Makes the whole text another one, by the smallest edit, as one step.
  void become(const QString &text, Origin origin, const QString &name);
  /// Several edits, each in the text that the ones before it left, as one undo step.
  void apply(const QList<Edit> &edits, const QString &name);

  [[nodiscard]] bool canUndo() const { return m_done > 0; }
  [[nodiscard]] bool canRedo() const { return m_done < m_steps.size(); }
  [[nodiscard]] QString undoName() const {
    return canUndo() ? m_steps[m_done - 1].name : QString();
  }
  [[nodiscard]] QString redoName() const { return canRedo() ? m_steps[m_done].name : QString(); }
  void undo();
  void redo();
  /// What is typed next begins a step of its own.
  void closeStep() { m_open = false; }

Q_SIGNALS:
  /// After each edit; text() has it.
  void edited(const arbiter::builder::Edit &edit, arbiter::builder::Origin origin);
  /// After a step, undo, redo, save or open.
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
  qsizetype m_done = 0; ///< steps that are not undone
  bool m_open = false;  ///< the last step is typing that may go on
  QElapsedTimer m_sinceTyping;
};

} // namespace arbiter::builder
