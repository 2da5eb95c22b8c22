// SPDX-License-Identifier: GPL-3.0-or-later
// The results page of a journey through the window: values and screens, in order.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim_core/lab/result_page.h"
#include "tests/ui/hands.h"
#include "ui/style/text.h"

namespace fulcrum::app::program_test {

class JourneyPage {
  public:
    /// `prefix`: of the pictures' names.
    JourneyPage(QWidget& window, const char* prefix) : window_(window), prefix_(QLatin1String(prefix)) {}

    /// Adds a picture of the current screen; stored in the folder FULCRUM_PICTURES.
    void step(const std::string& picture, const std::string& what) {
        const QString name = next_name(picture);
        ui::window_test::keep_picture(window_, name);
        list(name, what);
    }
    /// Adds a picture that is made elsewhere.
    QString next_name(const std::string& picture) const {
        return QStringLiteral("%1-%2-%3")
            .arg(prefix_)
            .arg(static_cast<int>(steps_.size()) + 1, 2, 10, QLatin1Char('0'))
            .arg(ui::text(picture));
    }
    void list(const QString& name, const std::string& what) {
        steps_.push_back({what, "![" + what + "](../images/" + name.toStdString() + ".png)"});
    }
    void say(const std::string& what, const std::string& figure) { figures_.push_back({what, figure}); }

    /// `tests`: the filter with which test_app makes the page.
    void write(const char* folder, const char* id, const char* title, const char* tests,
               const std::string& about) const {
        lab::ResultPage page(id, title,
                             std::string("FULCRUM_PICTURES=docs/images FULCRUM_JOURNEY_PAGE=") + folder +
                                 " xvfb-run -a -s '-screen 0 1280x800x24' test_app --gtest_filter=" + tests);
        page.paragraph(about);
        lab::ResultTable table;
        table.columns = {"what", "value"};
        table.rows = figures_;
        page.table(table);
        for (const auto& [what, picture] : steps_) {
            page.paragraph(what);
            page.paragraph(picture);
        }
        page.write(folder, lab::this_machine(lab::build_info()));
    }

  private:
    QWidget& window_;
    QString prefix_;
    std::vector<std::pair<std::string, std::string>> steps_;  // description, picture
    std::vector<std::vector<std::string>> figures_;
};

}  // namespace fulcrum::app::program_test
