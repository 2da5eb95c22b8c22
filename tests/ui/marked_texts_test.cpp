// SPDX-License-Identifier: GPL-3.0-or-later
// Every text of every screen goes through the translation: in a language that puts each text between marks,
// nothing but data is outside of them.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QSet>
#include <QTableWidget>
#include <QTranslator>
#include <algorithm>
#include <map>

#include "tests/ui/heard.h"
#include "tests/ui/screens.h"
#include "tests/ui/shown_texts.h"
#include "ui/language/language.h"

namespace fulcrum::ui::window_test {
namespace {

constexpr QChar opened(0x27E6), closed(0x27E7);

/// Keeps the places for numbers and names. Qt's own texts are translated by Qt.
class Marks : public QTranslator {
  public:
    QString translate(const char* context, const char* source, const char* /*disambiguation*/,
                      int /*n*/) const override {
        const bool of_qt = context != nullptr && context[0] == 'Q' && QChar::isUpper(uint(context[1]));
        if (of_qt && qstrcmp(context, "QShortcut") != 0) return {};
        return source == nullptr || *source == '\0' ? QString() : opened + QString::fromUtf8(source) + closed;
    }
    bool isEmpty() const override { return false; }
};

/// What is left without what was translated and all that was put into it. A text may be cut off at its end,
/// or be the end of one.
QString outside_marks(const QString& shown) {
    QString left;
    int depth = 0;
    for (const QChar letter : shown) {
        if (letter == opened) {
            ++depth;
        } else if (letter == closed) {
            if (depth == 0) left.clear();
            depth = std::max(0, depth - 1);
        } else if (depth == 0) {
            left += letter;
        }
    }
    return left;
}

/// Names and units: the same in every language. Ids, paths, versions and addresses have a sign or a digit in
/// them.
const QSet<QString>& data_words() {
    static const QSet<QString> words{
        // The people of these tests, their programme and their cohort; who performs demonstrations.
        "Alma", "Admin", "alma", "Tara", "Trainee", "tara", "Ed", "Educator", "ed", "Dora", "Director",
        "dora", "Spring", "Department", "of", "Surgery", "University", "Hospital",
        // Names.
        "Fulcrum", "English", "Deutsch", "PDF", "CSV", "XLSX", "JSON", "OpenIGTLink", "OpenGL",
        "peg-transfer", "postgresql", "USB", "JIGSAWS", "PerkTutor", "ROSMA",
        // The stages' titles in a draft, where they are edited as they are stored.
        "Instruments", "Tissue", "Dissection",
        // Units.
        "mm", "ms", "mL", "mJ", "mN", "Nm", "Ns", "kPa", "Pa", "Hz", "min", "MiB", "kB", "MB"};
    return words;
}

QStringList unmarked_words(const QString& shown) {
    static const QRegularExpression gaps(QStringLiteral("[\\s,;:()·•–—„“”\"…×✓✕!?→←▲▼+*]+"));
    static const QRegularExpression word(QStringLiteral("^\\p{L}[\\p{L}'’-]+\\.?$"));
    QStringList words;
    for (QString one : outside_marks(shown).split(gaps, Qt::SkipEmptyParts)) {
        if (!word.match(one).hasMatch()) continue;
        if (one.endsWith(QLatin1Char('.'))) one.chop(1);
        if (!data_words().contains(one)) words << one;
    }
    return words;
}

void add_model_texts(const QAbstractItemModel& model, QStringList& texts) {
    constexpr int most_rows = 30;  // below them are more of the same
    for (int column = 0; column < model.columnCount(); ++column)
        for (const int role : {Qt::DisplayRole, Qt::ToolTipRole, Qt::AccessibleTextRole}) {
            texts << model.headerData(column, Qt::Horizontal, role).toString();
            for (int row = 0; row < std::min(most_rows, model.rowCount()); ++row)
                texts << model.index(row, column).data(role).toString();
        }
}

/// All that a widget says, also while it is hidden.
QStringList texts_of(const QWidget& widget) {
    QStringList texts{widget.toolTip(), widget.accessibleName(), widget.accessibleDescription(),
                      widget.statusTip(), widget.windowTitle()};
    for (const QAction* action : widget.actions()) texts << action->text();
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) texts << as_shown(*label);
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        texts << button->text().replace("&&", "&");
    if (const auto* box = qobject_cast<const QGroupBox*>(&widget)) texts << box->title();
    if (const auto* edit = qobject_cast<const QLineEdit*>(&widget)) texts << edit->placeholderText();
    if (const auto* edit = qobject_cast<const QPlainTextEdit*>(&widget)) texts << edit->placeholderText();
    if (const auto* spin = qobject_cast<const QSpinBox*>(&widget))
        texts << spin->prefix() << spin->suffix() << spin->specialValueText();
    if (const auto* spin = qobject_cast<const QDoubleSpinBox*>(&widget))
        texts << spin->prefix() << spin->suffix() << spin->specialValueText();
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
        for (int i = 0; i < tabs->count(); ++i) texts << tabs->tabText(i) << tabs->tabToolTip(i);
    if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) add_model_texts(*combo->model(), texts);
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget); view != nullptr && view->model())
        add_model_texts(*view->model(), texts);
    return texts;
}

class MarkedTexts : public Screens {
  protected:
    MarkedTexts() { QCoreApplication::installTranslator(&marks_); }
    ~MarkedTexts() override {
        window.reset();
        QCoreApplication::removeTranslator(&marks_);
        use_language(Language::english);
    }
    void look(const QString& screen) {
        for (const QString& said : Heard::lines()) take(said, screen + ", announced");
        Heard::lines().clear();
        for (const QWidget* widget : window->findChildren<QWidget*>()) {
            // Qt's own parts: Qt translates what they say.
            if (widget->objectName().startsWith("qt_") ||
                qobject_cast<const QTabBar*>(widget->parentWidget()) != nullptr)
                continue;
            const QString place =
                screen + ", " + widget->metaObject()->className() + ' ' + widget->objectName();
            for (const QString& shown : texts_of(*widget)) take(shown, place);
        }
        for (const QString& shown : texts_of(*window)) take(shown, screen + ", window");
    }
    void take(const QString& shown, const QString& place) {
        if (shown.isEmpty() || seen_.contains(shown)) return;
        seen_ << shown;
        const QStringList words = unmarked_words(shown);
        if (!words.isEmpty())
            unmarked_.emplace(words.join(' ').toStdString(), place + ": " + shown.left(160));
    }
    Marks marks_;
    QSet<QString> seen_;
    std::map<std::string, QString> unmarked_;  ///< words and where they were seen first
};

TEST_F(MarkedTexts, OnEveryScreenAreAllThatIsNotData) {
    open({1280, 800});
    const Heard heard;
    const std::string attempt = perform();
    visit(attempt, [&](const QString& screen) { look(screen); });
    for (const auto& [words, place] : unmarked_)
        ADD_FAILURE() << "not translated: " << words << " (" << place.toStdString() << ')';
    EXPECT_GT(seen_.size(), 800);
}

TEST_F(MarkedTexts, AreFoundInEveryKindOfText) {
    const QString marked = QCoreApplication::translate("fulcrum::ui::text", "Hello %1").arg("Tara & Zoe");
    EXPECT_EQ(unmarked_words(marked), QStringList());
    EXPECT_EQ(unmarked_words(marked + " and 3.5 mm of A2, path_length@3 in /a/b.json"),
              (QStringList{"and", "in"}));
    EXPECT_EQ(unmarked_words(marked.left(6)), QStringList()) << "cut off";
    EXPECT_EQ(unmarked_words(marked.mid(3)), QStringList()) << "the end of one";
    EXPECT_EQ(QCoreApplication::translate("fulcrum::ui::text", "%n days", nullptr, 3),
              opened + QString("3 days") + closed);
    EXPECT_EQ(QCoreApplication::translate("QLineEdit", "&Undo"), "&Undo");
    QWidget page;
    new QLabel("label", &page);
    new QPushButton("button", &page);
    auto* combo = new QComboBox(&page);
    combo->addItems({"choice"});
    auto* table = new QTableWidget(1, 1, &page);
    table->setItem(0, 0, new QTableWidgetItem("cell"));
    table->item(0, 0)->setToolTip("tip");
    table->setHorizontalHeaderLabels({"header"});
    (new QLineEdit(&page))->setPlaceholderText("placeholder");
    (new QTabBar(&page))->addTab("tab");
    auto* spin = new QSpinBox(&page);
    spin->setSuffix(" weeks");
    spin->setAccessibleName("spoken");
    QStringList words;
    for (const QWidget* widget : page.findChildren<QWidget*>())
        for (const QString& shown : texts_of(*widget)) words << unmarked_words(shown);
    for (const char* kind :
         {"label", "button", "choice", "cell", "tip", "header", "placeholder", "tab", "weeks", "spoken"})
        EXPECT_TRUE(words.contains(kind)) << kind;
}

}  // namespace
}  // namespace fulcrum::ui::window_test
