#pragma once
#include <QString>

namespace arbiter::builder {

class MainWindow;

/// A picture of the window, and what is done before it is taken, in this order.
struct Shot {
  QString png;        ///< the file
  QString edit;       ///< "FROM=>TO" replaces a piece of the text when it is drawn; empty: nothing
  QString pixel;      ///< "X,Y" is traced, of the document or of the application; empty: none
  int watched = 0;    ///< the line whose register is shown over the whole picture; 0: none
  qint64 process = 0; ///< an application that is attached to; 0: none
  bool small = false; ///< 32 shades a channel, well packed
};

/// Takes it as soon as the document is drawn, the problems are known, and all of the above has
/// come; then ends the application. It ends with code 1 after 30 s in any case, with what is there,
/// and where the PNG cannot be written; standard error says why.
void takeScreenshot(MainWindow &window, const Shot &shot);

} // namespace arbiter::builder
