#include "apps/builder/view/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QStyleFactory>
#include <cmath>

namespace arbiter::builder {

namespace {

Colors lightColors() {
  Colors c;
  c.background = QColor(0xffffff);
  c.text = QColor(0x1b1f24);
  c.dim = QColor(0x5b646f);
  c.line = QColor(0xf2f5f9);
  c.traced = QColor(0xfff3c4);
  c.error = QColor(0xb3261e);
  c.warning = QColor(0x8a5300);
  c.note = QColor(0x0b5cad);
  c.opcode = QColor(0x0b4fa8);
  c.keyword = QColor(0x7a1fa2);
  c.option = QColor(0x8a4b08);
  c.binding = QColor(0x00635a);
  c.name = QColor(0x1b1f24);
  c.parameter = QColor(0x5c3c00);
  c.number = QColor(0xa31545);
  c.comment = QColor(0x55606b);
  c.panel = QColor(0x2f6b1e);
  c.good = QColor(0x2e7d32);
  c.amber = QColor(0x9a6200);
  return c;
}

Colors darkColors() {
  Colors c;
  c.dark = true;
  c.background = QColor(0x1b1e23);
  c.text = QColor(0xe3e6ea);
  c.dim = QColor(0x9aa4af);
  c.line = QColor(0x24282f);
  c.traced = QColor(0x3b3510);
  c.error = QColor(0xff8a80);
  c.warning = QColor(0xffc46b);
  c.note = QColor(0x8cc3ff);
  c.opcode = QColor(0x82b8ff);
  c.keyword = QColor(0xd7a6ff);
  c.option = QColor(0xffb878);
  c.binding = QColor(0x6fd6c6);
  c.name = QColor(0xe3e6ea);
  c.parameter = QColor(0xe8cf8e);
  c.number = QColor(0xff9ec0);
  c.comment = QColor(0x9aa4af);
  c.panel = QColor(0xa5d689);
  c.good = QColor(0x81c784);
  c.amber = QColor(0xffc46b);
  return c;
}

Colors &current() {
  static Colors all = lightColors();
  return all;
}

QPalette paletteOf(const Colors &c) {
  QPalette palette;
  const QColor window = c.dark ? QColor(0x25292f) : QColor(0xf0f2f4);
  const QColor button = c.dark ? QColor(0x32373f) : QColor(0xe4e7eb);
  const QColor accent = c.dark ? QColor(0x3d6fb4) : QColor(0x1f66c1);
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::WindowText, c.text);
  palette.setColor(QPalette::Base, c.background);
  palette.setColor(QPalette::AlternateBase, c.line);
  palette.setColor(QPalette::Text, c.text);
  palette.setColor(QPalette::Button, button);
  palette.setColor(QPalette::ButtonText, c.text);
  palette.setColor(QPalette::ToolTipBase, c.background);
  palette.setColor(QPalette::ToolTipText, c.text);
  palette.setColor(QPalette::PlaceholderText, c.dim);
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, c.note);
  palette.setColor(QPalette::BrightText, c.error);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, c.dark ? QColor(0x7d8691) : QColor(0x7b838c));
  return palette;
}

double linear(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor &color) {
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
         0.0722 * linear(color.blueF());
}

} // namespace

const Colors &colors() { return current(); }

void applyScheme(QApplication &application, Scheme scheme) {
  static const bool desktopIsDark = application.palette().color(QPalette::Window).lightness() < 128;
  const bool dark = scheme == Scheme::Dark || (scheme == Scheme::System && desktopIsDark);
  current() = dark ? darkColors() : lightColors();
  application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  application.setPalette(paletteOf(current()));
}

Scheme schemeNamed(const QString &name) {
  return name == u"dark" ? Scheme::Dark : name == u"light" ? Scheme::Light : Scheme::System;
}

double contrast(const QColor &a, const QColor &b) {
  const double first = luminance(a) + 0.05, second = luminance(b) + 0.05;
  return std::max(first, second) / std::min(first, second);
}

QIcon applicationIcon() {
  QIcon icon;
  for (const int side : {16, 32, 48, 128}) {
    QPixmap pixmap(side, side);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(side / 64.0, side / 64.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0x1b1e23));
    painter.drawRoundedRect(QRectF(2, 2, 60, 60), 10, 10);
    QLinearGradient sphere(18, 16, 50, 56);
    sphere.setColorAt(0, QColor(0xffd166));
    sphere.setColorAt(0.5, QColor(0xef476f));
    sphere.setColorAt(1, QColor(0x2a3fa0));
    painter.setBrush(sphere);
    painter.drawEllipse(QRectF(20, 18, 36, 36));
    painter.setBrush(QColor(0xe3e6ea));
    for (const QRectF bar : {QRectF(8, 14, 16, 4), QRectF(8, 24, 10, 4), QRectF(8, 34, 8, 4)})
      painter.drawRoundedRect(bar, 2, 2);
    icon.addPixmap(pixmap);
  }
  return icon;
}

} // namespace arbiter::builder
