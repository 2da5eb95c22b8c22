// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum-lab: runs the commands that `fulcrum lab` passes on.
#include <QGuiApplication>
#include <iostream>
#include <memory>

#include "app/cli/command_line.h"
#include "app/lab/allocation_counter.h"
#include "app/lab/commands.h"
#include "sim_core/lab/bench.h"

int main(int argc, char** argv) {
    using namespace fulcrum;
    app::keep_standard_streams();
    lab::set_allocation_counter(app::allocations_of_this_thread);
    QCoreApplication::setApplicationName("Fulcrum");
    QCoreApplication::setOrganizationName("Fulcrum");
    const app::CommandTable table = app::laboratory_table();
    if (argc > 1)
        return app::run_command_line(table, argc, argv, [](int& count, char** words) {
            return std::make_unique<QGuiApplication>(count, words);
        });
    std::cout << table.help();
    return 0;
}
