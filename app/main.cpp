// SPDX-License-Identifier: GPL-3.0-or-later
// The program: without a command it opens the window, with a command it runs that command.
#include <cstring>
#include <memory>
#include <optional>
#include <string>

#include "app/cli/command_line.h"
#include "app/cli/display.h"
#include "app/services/application.h"
#include "app/services/program.h"
#include "ui/shell/window_application.h"

namespace {

/// `fulcrum --db ""`, for example from a script whose variable is not set: the window would open the usual
/// store.
int refuse_empty_store(int& argc, char** argv) {
    using namespace fulcrum;
    const QCoreApplication application(argc, argv);
    return app::guarded([] {
        app::use_language_or(ui::Language::english);
        throw app::UsageError(
            "--db", QT_TRANSLATE_NOOP("errors", "its argument is empty"),
            {QT_TRANSLATE_NOOP("errors", "write %1 %2; %3"), std::string("--db"), app::placeholders("FILE"),
             Sentence(QT_TRANSLATE_NOOP("errors", "see fulcrum --help"))});
        return 0;
    });
}

}  // namespace

int main(int argc, char** argv) {
    using namespace fulcrum;
    app::keep_standard_streams();
    QCoreApplication::setApplicationName("Fulcrum");
    QCoreApplication::setOrganizationName("Fulcrum");
    const bool named_store = argc == 3 && std::strcmp(argv[1], "--db") == 0;
    if (named_store && argv[2][0] == '\0') return refuse_empty_store(argc, argv);
    if (argc > 1 && !named_store)
        return app::run_command_line(app::program_commands(), argc, argv, [](int& count, char** words) {
            return std::make_unique<QApplication>(count, words);
        });
    std::optional<app::DisplayNeeded> display(
        QT_TRANSLATE_NOOP("errors",
                          "start fulcrum on a desktop, or use its commands, which need no display (fulcrum "
                          "--help lists them)"));
    const ui::WindowApplication application(argc, argv);
    display.reset();
    app::set_plain_formats();
    const std::string store = named_store ? argv[2] : "";
    return app::guarded([&] { return app::run_window(store); });
}
