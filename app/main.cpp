// SPDX-License-Identifier: GPL-3.0-or-later
// The program: without a command it opens the window, with a command it runs that command.
#include <cstring>
#include <memory>
#include <optional>

#include "app/cli/command_line.h"
#include "app/cli/display.h"
#include "app/services/application.h"
#include "app/services/program.h"
#include "ui/shell/window_application.h"

int main(int argc, char** argv) {
    using namespace fulcrum;
    app::keep_standard_streams();
    QCoreApplication::setApplicationName("Fulcrum");
    QCoreApplication::setOrganizationName("Fulcrum");
    const bool named_store = argc == 3 && std::strcmp(argv[1], "--db") == 0;
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
