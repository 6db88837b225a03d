#pragma once
#include <functional>

#include "apps/builder/model/workbench.h"
#include "apps/builder/view/panels/table.h"

namespace arbiter::builder {

/// Lists the problems of the text, each with its place; Return or a click goes there.
class ProblemsPanel : public Table {
public:
  /// \param goTo called with an offset of the text
  ProblemsPanel(Workbench &bench, std::function<void(qsizetype)> goTo);

  [[nodiscard]] int errors() const;

private:
  void fill();

  Workbench &m_bench;
};

} // namespace arbiter::builder
