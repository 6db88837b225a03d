#pragma once
#include <QDialog>

#include "apps/builder/model/panels/sequence.h"
#include "apps/builder/model/workbench.h"

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace arbiter::builder {

/// Exports frames of the document as PNG files: asks which and where to, then shows the progress.
/// Closing it stops the export.
class ExportDialog : public QDialog {
public:
  /// \param folder the proposed folder
  ExportDialog(Workbench &bench, const QString &folder, QWidget *parent = nullptr);

protected:
  void reject() override;

private:
  void build(const QString &folder);
  void begin();
  void ended(const QString &complaint);
  void setRunning(bool running);
  void browse();
  [[nodiscard]] SequenceRequest request() const;

  Workbench &m_bench;
  SequenceExport m_export;
  double m_rate = 60; ///< frames a second of the document
  QSpinBox *m_first, *m_frames;
  QDoubleSpinBox *m_seconds;
  QLineEdit *m_folder, *m_name;
  QProgressBar *m_progress;
  QLabel *m_state;
  QPushButton *m_start, *m_close, *m_browse;
};

} // namespace arbiter::builder
