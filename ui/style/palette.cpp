// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/palette.h"

#include <QApplication>
#include <QEvent>
#include <QFont>
#include <QPalette>
#include <QPointer>
#include <QStyle>
#include <QStyleFactory>
#include <QVector>
#include <QWidget>

#include "ui/style/keyboard_aid.h"

/// Resources of a static library are linked in only where somebody asks for them, outside any namespace.
static void load_style_resources() {
    Q_INIT_RESOURCE(style);
}

namespace fulcrum::ui {
namespace {

Theme theme_in_force = Theme::light;
int percent_in_force = 100;

constexpr double usual_points = 10.5;

/// A size in points of the usual text, as the style sheet writes it for the size in use.
QString points(double usual) {
    return QString::number(usual * percent_in_force / 100.0, 'f', 2) + QStringLiteral("pt");
}

const char* const sheet_source = R"(
QMainWindow, QWidget#page, QStackedWidget, QScrollArea, QWidget#page_body { background: @window; }
QScrollArea { border: none; }
QLabel { background: transparent; }
QLabel[role="title"] { font-size: @title_size; font-weight: 600; }
QLabel[role="heading"] { font-size: @heading_size; font-weight: 600; }
QLabel[role="muted"] { color: @muted; }
QLabel[role="number"] { font-size: @number_size; font-weight: 600; }
QLabel[role="good"] { color: @good; font-weight: 600; }
QLabel[role="bad"] { color: @bad; font-weight: 600; }
QLabel[role="strong"] { font-weight: 600; }
QLabel[role="neutral"] { color: @muted; font-weight: 600; }
QLabel[tint="good"] { color: @good; }
QLabel[tint="bad"] { color: @bad; }
QLabel[tint="muted"] { color: @muted; }
QFrame[role="card"] { background: @card; border: 1px solid @line; border-radius: 10px; }
QFrame[role="top_bar"] { background: @card; border: none; border-bottom: 1px solid @line; }
QFrame[role="rail"] { background: @card; border: none; border-right: 1px solid @line; }
QFrame[role="banner"] { background: @warning; border: none; }
QFrame[role="banner"] QLabel { color: #1b1b1b; font-weight: 600; }
QFrame[role="message"] { background: @raised; border: 1px solid @accent; border-radius: 8px; }
QFrame[role="error"] { background: @raised; border: 2px solid @bad; border-radius: 8px; }
QPushButton { background: @raised; border: 1px solid @line; border-radius: 7px; padding: 7px 16px; min-height: 20px; }
QPushButton:hover { border-color: @accent; }
QPushButton:pressed { background: @line; }
QPushButton:focus { border: 2px solid @accent; padding: 6px 15px; }
QPushButton:disabled { color: @muted; background: @window; }
QPushButton[role="primary"] { background: @accent; color: @accent_text; border: 1px solid @accent; font-weight: 600; }
QPushButton[role="primary"]:focus { border: 2px solid @text; }
QPushButton[role="primary"]:disabled { background: @line; color: @muted; border-color: @line; }
QPushButton[role="rail"] { background: transparent; border: none; border-radius: 7px; padding: 9px 8px; text-align: left; }
QPushButton[role="rail"]:hover { background: @raised; }
QPushButton[role="rail"]:checked { background: @accent; color: @accent_text; font-weight: 600; }
QPushButton[role="rail"]:focus { border: 2px solid @text; padding: 7px 6px; }
QPushButton[role="link"] { background: transparent; border: none; color: @accent; padding: 3px 4px; text-align: left; }
QPushButton[role="link"]:hover, QPushButton[role="link"]:focus { text-decoration: underline; border: none; }
QPushButton[role="card"] { background: @card; border: 1px solid @line; border-radius: 10px; padding: 14px; text-align: left; }
QPushButton[role="card"]:focus, QPushButton[role="card"]:hover { border: 2px solid @accent; padding: 13px; }
QLineEdit, QPlainTextEdit, QTextEdit, QComboBox, QSpinBox, QDoubleSpinBox, QDateEdit { background: @window; border: 1px solid @line; border-radius: 6px; padding: 6px 8px; selection-background-color: @accent; selection-color: @accent_text; }
QLineEdit:focus, QPlainTextEdit:focus, QComboBox:focus, QTextEdit:focus, QSpinBox:focus, QDoubleSpinBox:focus, QDateEdit:focus { border: 2px solid @accent; padding: 5px 7px; }
QLabel:focus { background: @raised; }
QComboBox::drop-down { border: none; width: 24px; }
QDateEdit::drop-down { border: none; width: 22px; }
QComboBox::down-arrow, QDateEdit::down-arrow { image: url(:/style/icons/arrow_@theme.svg); width: 12px; height: 12px; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { width: 22px; border: none; background: transparent; }
QAbstractSpinBox::up-arrow { image: url(:/style/icons/arrow_up_@theme.svg); width: 10px; height: 10px; }
QAbstractSpinBox::down-arrow { image: url(:/style/icons/arrow_@theme.svg); width: 10px; height: 10px; }
QComboBox QAbstractItemView { background: @card; selection-background-color: @accent; selection-color: @accent_text; border: 1px solid @line; }
QTableWidget, QTableView, QListWidget { background: @card; alternate-background-color: @raised; border: 1px solid @line; border-radius: 8px; gridline-color: @line; selection-background-color: @accent; selection-color: @accent_text; }
QTableView:focus, QListWidget:focus { border-color: @accent; }
QTableView::item { border: none; padding: 4px 5px; }
QListWidget::item { border: none; padding: 4px 8px; }
QTableView::item:selected, QListWidget::item:selected { background: @accent; color: @accent_text; }
QAbstractScrollArea::corner { background: transparent; border: none; }
QHeaderView { background: transparent; }
QHeaderView::section { background: transparent; color: @muted; border: none; border-bottom: 1px solid @line; padding: 7px 8px; font-weight: 600; }
QTableCornerButton::section { background: @card; border: none; }
QProgressBar { background: @raised; border: none; border-radius: 4px; height: 8px; text-align: center; color: transparent; }
QProgressBar::chunk { background: @accent; border-radius: 4px; }
QSlider::groove:horizontal { background: @line; height: 6px; border-radius: 3px; }
QSlider::sub-page:horizontal { background: @accent; border-radius: 3px; }
QSlider::handle:horizontal { background: @accent; width: 16px; margin: -6px 0; border-radius: 8px; border: 2px solid @card; }
QSlider:focus { outline: none; border: 1px solid @accent; border-radius: 4px; }
QTabWidget::pane { border: none; border-top: 1px solid @line; }
QTabBar::tab { background: transparent; padding: 8px 16px; border-bottom: 3px solid transparent; color: @muted; }
QTabBar::tab:selected { color: @text; border-bottom: 3px solid @accent; }
QTabBar::tab:focus { color: @accent; }
QCheckBox, QRadioButton { background: transparent; spacing: 8px; padding: 3px; }
QCheckBox:focus, QRadioButton:focus { color: @accent; }
QCheckBox::indicator, QListWidget::indicator { width: 16px; height: 16px; border: 1px solid @muted; border-radius: 4px; background: @window; }
QCheckBox::indicator:checked, QListWidget::indicator:checked { background: @accent; border-color: @accent; image: url(:/style/icons/check_@theme.svg); }
QRadioButton::indicator { width: 10px; height: 10px; border: 4px solid @window; border-radius: 9px; background: @window; }
QRadioButton::indicator:unchecked { width: 16px; height: 16px; border: 1px solid @muted; border-radius: 9px; }
QRadioButton::indicator:checked { width: 8px; height: 8px; border: 5px solid @accent; border-radius: 9px; background: @card; }
QRadioButton::indicator:disabled, QCheckBox::indicator:disabled { border-color: @line; }
QRadioButton:disabled, QCheckBox:disabled { color: @muted; }
QToolTip { background: @card; color: @text; border: 1px solid @line; padding: 4px; }
QScrollBar:vertical { background: transparent; width: 11px; margin: 2px; }
QScrollBar::handle:vertical { background: @line; border-radius: 4px; min-height: 30px; }
QScrollBar:horizontal { background: transparent; height: 11px; margin: 2px; }
QScrollBar::handle:horizontal { background: @line; border-radius: 4px; min-width: 30px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QSplitter::handle { background: transparent; }
)";

QString style_sheet(const Palette& p) {
    QString sheet = QString::fromLatin1(sheet_source);
    for (const auto& [token, size] :
         {std::pair{"@title_size", 20.0}, std::pair{"@heading_size", 13.0}, std::pair{"@number_size", 24.0}})
        sheet.replace(QLatin1String(token), points(size));
    const std::pair<const char*, QColor> tokens[] = {{"@accent_text", p.accent_text},
                                                     {"@accent", p.accent},
                                                     {"@window", p.window},
                                                     {"@card", p.card},
                                                     {"@raised", p.raised},
                                                     {"@line", p.line},
                                                     {"@text", p.text},
                                                     {"@muted", p.muted},
                                                     {"@good", p.good},
                                                     {"@bad", p.bad},
                                                     {"@warning", p.warning}};
    sheet.replace(QLatin1String("@theme"),
                  p.window.lightness() > 128 ? QStringLiteral("light") : QStringLiteral("dark"));
    for (const auto& [token, colour] : tokens) sheet.replace(QLatin1String(token), colour.name());
    return sheet;
}

/// The style sheet in force, on a widget and then on what it contains.
void style_again(QWidget& widget) {
    widget.style()->polish(&widget);
    QEvent changed(QEvent::StyleChange);
    QCoreApplication::sendEvent(&widget, &changed);
    // A widget that notices may remove what it contains.
    QVector<QPointer<QWidget>> inside;
    for (QObject* child : widget.children())
        if (child->isWidgetType()) inside.push_back(static_cast<QWidget*>(child));
    for (const QPointer<QWidget>& one : inside)
        if (!one.isNull()) style_again(*one);
}

/// Given another style sheet, Qt styles each widget once for itself and once more for each of those around
/// it, ten times on a usual page. Where its list of styled widgets is empty it leaves that to us.
void set_style_sheet(QApplication& application, const QString& sheet) {
    const bool is_first = application.styleSheet().isEmpty();  // Qt styles each widget once
    if (!is_first) QApplication::style()->unpolish(&application);
    application.setStyleSheet(sheet);
    if (is_first) return;
    for (QWidget* window : QApplication::topLevelWidgets())
        if (window->parentWidget() == nullptr && window->windowType() != Qt::Desktop) style_again(*window);
}

}  // namespace

const Palette& palette_of(Theme theme) {
    static const Palette light{QColor(0xF5F6F8), QColor(0xFFFFFF), QColor(0xEDF0F4), QColor(0xC9CFD8),
                               QColor(0x17202B), QColor(0x566272), QColor(0x005A9C), QColor(0xFFFFFF),
                               QColor(0x0072B2), QColor(0xC05A00), QColor(0x00724F), QColor(0xB23A00),
                               QColor(0xF2B632), QColor(0x6B7684), QColor(0x852A82)};
    static const Palette dark{QColor(0x14181E), QColor(0x1C222A), QColor(0x262E38), QColor(0x3A4553),
                              QColor(0xE8EDF3), QColor(0x9BA8B7), QColor(0x56B4E9), QColor(0x0B1620),
                              QColor(0x56B4E9), QColor(0xF0A33A), QColor(0x3CCF9B), QColor(0xFF8A5B),
                              QColor(0xF0E442), QColor(0x778392), QColor(0xF0C0D1)};
    return theme == Theme::light ? light : dark;
}

Theme current_theme() {
    return theme_in_force;
}

int text_percent() {
    return percent_in_force;
}

void apply_text_size(QApplication& application, int percent) {
    percent_in_force = percent;
    apply_theme(application, theme_in_force);
}

int with_text(int pixels) {
    return pixels * percent_in_force / 100;
}

void apply_theme(QApplication& application, Theme theme) {
    load_style_resources();
    theme_in_force = theme;
    const Palette& p = palette_of(theme);
    // Each of these is carried to every widget of every page, so what stays as it is is not set again.
    constexpr const char* styled = "fulcrum_styled";
    if (!application.property(styled).toBool()) {
        application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
        application.setProperty(styled, true);
        aid_keyboard(application);
    }
    QFont font = application.font();
    font.setPointSizeF(usual_points * percent_in_force / 100.0);
    if (font != application.font()) application.setFont(font);
    QPalette colours;
    colours.setColor(QPalette::Window, p.window);
    colours.setColor(QPalette::WindowText, p.text);
    colours.setColor(QPalette::Base, p.card);
    colours.setColor(QPalette::AlternateBase, p.raised);
    colours.setColor(QPalette::Text, p.text);
    colours.setColor(QPalette::Button, p.raised);
    colours.setColor(QPalette::ButtonText, p.text);
    colours.setColor(QPalette::Highlight, p.accent);
    colours.setColor(QPalette::HighlightedText, p.accent_text);
    colours.setColor(QPalette::ToolTipBase, p.card);
    colours.setColor(QPalette::ToolTipText, p.text);
    colours.setColor(QPalette::PlaceholderText, p.muted);
    colours.setColor(QPalette::Disabled, QPalette::Text, p.muted);
    colours.setColor(QPalette::Disabled, QPalette::ButtonText, p.muted);
    if (colours != application.palette()) application.setPalette(colours);
    const QString sheet = style_sheet(p);
    if (sheet != application.styleSheet()) set_style_sheet(application, sheet);
}

}  // namespace fulcrum::ui
