#pragma once
#include <QWidget>

#include "apps/builder/model/attach/attachment.h"

class QPushButton;

namespace arbiter::builder {

class Table;

/// Shows the parameters of an application's program. A local or env parameter can be changed while
/// the application draws; it keeps the value until it is released.
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
