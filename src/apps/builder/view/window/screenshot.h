#pragma once
#include <QString>

namespace arbiter::builder {

class MainWindow;

/// A picture of the window, and the steps before it is taken, in this order.
struct Shot {
  QString png;        ///< the file
  QString edit;       ///< "FROM=>TO" replaces a piece of the drawn text; empty: no edit
  QString pixel;      ///< "X,Y" is traced, in the document or the application; empty: none
  int watched = 0;    ///< the line whose register is shown as a picture; 0: none
  qint64 process = 0; ///< an application to attach to; 0: none
  bool small = false; ///< reduces the colors, for a small file
};

/// Takes the picture as soon as the document is drawn, the problems are known, and all steps are
/// done; then ends the application. It ends with code 1 if the PNG cannot be written, and after 30
/// s with the picture at that time; standard error tells why.
void takeScreenshot(MainWindow &window, const Shot &shot);

} // namespace arbiter::builder
