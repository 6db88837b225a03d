
// Headers for the window's views; standard_headers.h says how they are used.

#include "qt_headers.h"

#include <QAction>
#include <QApplication>
#include <QBoxLayout>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QMenu>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSlider>
#include <QSyntaxHighlighter>
#include <QTableWidget>
#include <QTextBlock>
#include <QToolButton>
#include <QWidget>
