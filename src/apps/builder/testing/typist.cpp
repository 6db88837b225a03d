#include "apps/builder/testing/typist.h"

#include <QApplication>
#include <unistd.h>

#include "apps/builder/view/editor/code_editor.h"
#include "apps/builder/view/window/main_window.h"

namespace arbiter::builder::testing {

int typeForEver(const QString &journals) {
  Places places = Places::standard();
  places.journals = journals;
  places.held = {};
  MainWindow window(places);
  window.openText({});
  window.show();
  window.editor().setFocus();
  Typist typist(window.editor(), 5);
  qsizetype said = 0;
  QTimer speak;
  QObject::connect(&speak, &QTimer::timeout, [&] {
    for (; said < typist.typed().size(); ++said)
      if (::write(STDOUT_FILENO, "\n", 1) != 1)
        ::_exit(1); // the test has ended
  });
  speak.start(1);
  return QApplication::exec();
}

} // namespace arbiter::builder::testing
