#pragma once
#include <QWidget>

#include "builder/model/attach/attachment.h"

class QPushButton;

namespace arbiter::builder {

class Table;

/// What an application's program reads. A local or env parameter is changed while the application
/// draws, and held until it is let go.
class AttachedValues : public QWidget {
public:
  explicit AttachedValues(Attachment &attachment);

private:
  void showValues();
  void build();
  void setComponent(int row, int component, double value);

  Attachment &m_attachment;
  Table *m_table;
  QPushButton *m_letGo;
  QStringList m_names; ///< of the rows
};

} // namespace arbiter::builder
