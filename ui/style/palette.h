// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of the window, dark and light. Data colours come from the Okabe-Ito set, which people with any
// of the common colour vision deficiencies can tell apart; hands also differ by dash, verdicts by sign, so
// that colour is never alone.
#pragma once

#include <QColor>
#include <QString>

class QApplication;

namespace fulcrum::ui {

enum class Theme { light, dark };

struct Palette {
    QColor window, card, raised, line, text, muted, accent, accent_text;
    QColor left_hand, right_hand;  ///< the two hands, everywhere
    QColor good, bad, warning, neutral;
    QColor limit;  ///< limits and benchmarks in charts and bars
};

const Palette& palette_of(Theme theme);
/// The theme in force; light until apply_theme was called.
Theme current_theme();
inline const Palette& colours() {
    return palette_of(current_theme());
}
/// Sets fonts, palette and style sheet of the whole application. UI thread.
void apply_theme(QApplication& application, Theme theme);
/// The sizes of text that are offered, in % of the usual one.
inline constexpr int text_percents[] = {100, 125, 150, 175, 200};
/// The size in use; 100 until apply_text_size was called.
int text_percent();
/// Sets the text of the whole application to a share of its usual size. UI thread.
void apply_text_size(QApplication& application, int percent);
/// Pixels that were measured for text of the usual size, for the size in use.
int with_text(int pixels);
/// For painting on paper whatever the theme.
inline const Palette& paper_palette() {
    return palette_of(Theme::light);
}

}  // namespace fulcrum::ui
