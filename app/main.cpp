// SPDX-License-Identifier: GPL-3.0-or-later
// The program: without a command it opens the window, with a command it runs that command.
#include <fcntl.h>
#include <unistd.h>

#include <QApplication>
#include <QTextCodec>
#include <clocale>
#include <csignal>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/lab/allocation_counter.h"
#include "app/services/application.h"
#include "app/services/program.h"
#include "database/rows/errors.h"
#include "sim_core/lab/bench.h"
#include "sim_core/numerics/input_error.h"
#include "ui/shell/window_application.h"

namespace {

using namespace fulcrum;

/// Prints the text as one line on standard error; returns the exit status.
int report(std::string line, int status) {
    for (char& c : line)
        if (c == '\n' || c == '\r') c = ' ';
    std::cerr << "fulcrum: " << line << '\n';
    return status;
}

template <typename Action>
int guarded(const Action& action) {
    try {
        return action();
    } catch (const InputError& error) {
        return report(error.what(), 2);
    } catch (const database::StoreError& error) {
        return report(error.what(), error.is_bad_input() ? 2 : 1);
    } catch (const database::AccessDenied& error) {
        return report(error.what(), 2);
    } catch (const database::SignInRefused& error) {
        return report(error.what(), 2);
    } catch (const nlohmann::json::exception& error) {
        return report(std::string("JSON: ") + error.what() + "; correct the document", 2);
    } catch (const std::bad_alloc&) {
        return report("not enough memory; close other programs or give smaller input", 1);
    } catch (const std::exception& error) {
        return report(error.what(), 1);
    }
}

/// A closed standard stream must not become the descriptor of the next file that is opened, such as the
/// store.
void keep_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) != -1) continue;
        const int other = open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // use fails
        if (other != stream && other >= 0) {
            dup2(other, stream);
            close(other);
        }
    }
}

/// After QCoreApplication has set the user's locale: numbers are read and written with a decimal point, and
/// file names are UTF-8, in every language.
void set_plain_formats() {
    std::setlocale(LC_NUMERIC, "C");
    QTextCodec::setCodecForLocale(QTextCodec::codecForName("UTF-8"));
}

int run(const app::Invocation& call) {
    const int status = call.run();
    if (!std::cout.flush())
        return report("standard output: not everything could be written; check the pipe or free some space",
                      1);
    return status;
}

int run_command_line(const std::vector<std::string>& words, int& argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);  // run() reports a closed pipe
    const app::Invocation call = app::program_commands().parse(words);
    if (!call.draws()) {
        const QCoreApplication application(argc, argv);
        set_plain_formats();
        return run(call);
    }
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    set_plain_formats();
    return run(call);
}

}  // namespace

int main(int argc, char** argv) {
    keep_standard_streams();
    lab::set_allocation_counter(app::allocations_of_this_thread);
    QCoreApplication::setApplicationName("Fulcrum");
    QCoreApplication::setOrganizationName("Fulcrum");
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (!words.empty()) return guarded([&] { return run_command_line(words, argc, argv); });
    const ui::WindowApplication application(argc, argv);
    set_plain_formats();
    return guarded(app::run_window);
}
