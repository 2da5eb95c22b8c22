// SPDX-License-Identifier: GPL-3.0-or-later
// The program: without a command it opens the window, with a command it runs that command.
#include "app/services/application.h"
#include "app/services/command_line.h"
#include "app/services/program.h"
#include "ui/shell/window_application.h"

int main(int argc, char** argv) {
    using namespace fulcrum;
    app::keep_standard_streams();
    QCoreApplication::setApplicationName("Fulcrum");
    QCoreApplication::setOrganizationName("Fulcrum");
    if (argc > 1) return app::run_command_line(app::program_commands(), argc, argv);
    const ui::WindowApplication application(argc, argv);
    app::set_plain_formats();
    return app::guarded(app::run_window);
}
