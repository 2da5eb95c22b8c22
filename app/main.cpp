// SPDX-License-Identifier: GPL-3.0-or-later
// The program: without a subcommand the window, with one the same product without it.
#include <QApplication>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/lab/allocation_counter.h"
#include "app/services/application.h"
#include "database/rows/errors.h"
#include "sim_core/lab/bench.h"
#include "sim_core/numerics/input_error.h"
#include "ui/shell/window_application.h"

namespace {

/// Exit status of an error, its one line on standard error.
int report(const std::string& line, int status) {
    std::cerr << "fulcrum: " << line << '\n';
    return status;
}

int guarded(int (*action)(const std::vector<std::string>&), const std::vector<std::string>& words) {
    using namespace fulcrum;
    try {
        return action(words);
    } catch (const app::UsageError& error) {
        return report(error.what(), 2);
    } catch (const InputError& error) {
        return report(error.what(), 2);
    } catch (const database::StoreError& error) {
        return report(error.what(), error.is_bad_input() ? 2 : 1);
    } catch (const database::AccessDenied& error) {
        return report(error.what(), 2);
    } catch (const database::SignInRefused& error) {
        return report(error.what(), 2);
    } catch (const nlohmann::json::exception& error) {
        return report(std::string("command line: JSON: ") + error.what() + "; mend the document", 2);
    } catch (const std::exception& error) {
        return report(error.what(), 1);
    }
}

}  // namespace

int main(int argc, char** argv) {
    using namespace fulcrum;
    lab::set_allocation_counter(app::allocations_of_this_thread);
    const std::vector<std::string> words(argv + 1, argv + argc);
    QCoreApplication::setApplicationName("Fulcrum");
    QCoreApplication::setOrganizationName("Fulcrum");
    if (!words.empty() && words[0] == "--version") {
        std::cout << "fulcrum " << app::version_line() << '\n';
        return 0;
    }
    if (!words.empty() && (words[0] == "--help" || words[0] == "help")) {
        std::cout << "usage: fulcrum                the application\n       fulcrum COMMAND ...    "
                  << app::command_list() << '\n';
        return 0;
    }
    if (!words.empty()) {
        const std::vector<std::string> drawing = {"demonstrate", "report"};
        const bool experiment = words.size() > 1 && words[0] == "lab" && words[1] == "experiment";
        const bool draws = experiment || std::find(drawing.begin(), drawing.end(), words[0]) != drawing.end();
        if (draws && qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY"))
            qputenv("QT_QPA_PLATFORM", "offscreen");
        if (draws) {
            QApplication application(argc, argv);
            return guarded(app::run_command, words);
        }
        QCoreApplication application(argc, argv);
        return guarded(app::run_command, words);
    }
    ui::WindowApplication application(argc, argv);
    return guarded([](const std::vector<std::string>&) { return app::run_window(); }, words);
}
