// SPDX-License-Identifier: GPL-3.0-or-later
// What a person reads of a text.
#pragma once

#include <QLabel>
#include <QTextDocument>

namespace fulcrum::ui::window_test {

/// What a label's format makes of its text.
inline QString as_shown(const QLabel& label) {
    QTextDocument document;
    const Qt::TextFormat format = label.textFormat();
    if (format == Qt::MarkdownText) {
        document.setMarkdown(label.text());
    } else if (format == Qt::RichText || (format == Qt::AutoText && Qt::mightBeRichText(label.text()))) {
        document.setHtml(label.text());
    } else {
        return label.text();
    }
    return document.toPlainText();
}

}  // namespace fulcrum::ui::window_test
