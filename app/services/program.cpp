// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/program.h"

#include "app/services/application.h"

namespace fulcrum::app {

const CommandTable& program_commands() {
    static const CommandTable table(
        [] {
            std::vector<Command> commands = headless_commands();
            for (const Command& command :
                 {report_command(), certificate_command(), demonstrate_command(), devices_command()})
                commands.push_back(command);
            for (const Command& command : schedule_commands()) commands.push_back(command);
            for (const Command& command : xapi_commands()) commands.push_back(command);
            return commands;
        }(),
        version_line());
    return table;
}

int run_command(const std::vector<std::string>& words) {
    return program_commands().parse(words).run();
}

}  // namespace fulcrum::app
