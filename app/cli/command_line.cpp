// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"

#include <fcntl.h>
#include <unistd.h>

#include <QTextCodec>
#include <clocale>
#include <csignal>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/commands.h"
#include "app/cli/display.h"
#include "database/rows/errors.h"
#include "sim_core/numerics/input_error.h"
#include "ui/language/error_text.h"

namespace fulcrum::app {
namespace {

/// Prints the error as one line on standard error; returns the exit status.
int report(const std::exception& error, int status) {
    std::cerr << "fulcrum: " << line_of(error) << '\n';
    return status;
}
int report(const Sentence& sentence, int status) {
    return report(WordedError(sentence), status);
}

int run(const Invocation& call) {
    const int status = call.run();
    if (!std::cout.flush())
        return report(QT_TRANSLATE_NOOP("errors",
                                        "standard output: not everything could be written; check the pipe or "
                                        "free some space"),
                      1);
    return status;
}

/// On the display if there is one.
std::unique_ptr<QCoreApplication> drawing_application(int& argc, char** argv, const MakeApplication& make) {
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const DisplayNeeded display(
        QT_TRANSLATE_NOOP("errors", "unset DISPLAY and WAYLAND_DISPLAY to draw without one"));
    return make(argc, argv);
}

}  // namespace

int guarded(const std::function<int()>& action) {
    try {
        return action();
    } catch (const InputError& error) {
        return report(error, 2);
    } catch (const database::StoreError& error) {
        return report(error, error.is_bad_input() ? 2 : 1);
    } catch (const database::AccessDenied& error) {
        // In the words of the screens: its own text names the operation as programs do.
        std::cerr << "fulcrum: " << ui::error_text(error).toStdString() << '\n';
        return 2;
    } catch (const database::SignInRefused& error) {
        return report(error, 2);
    } catch (const nlohmann::json::exception& error) {
        return report({QT_TRANSLATE_NOOP("errors", "JSON: %1; correct the document"), error.what()}, 2);
    } catch (const std::bad_alloc&) {
        return report(
            QT_TRANSLATE_NOOP("errors", "not enough memory; close other programs or give smaller input"), 1);
    } catch (const std::exception& error) {
        return report(error, 1);
    }
}

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

void set_plain_formats() {
    std::setlocale(LC_NUMERIC, "C");
    QTextCodec::setCodecForLocale(QTextCodec::codecForName("UTF-8"));
}

void use_language_or(ui::Language otherwise) {
    const std::optional<ui::Language> language = ui::chosen_language(otherwise);
    if (!language)
        throw InputError("FULCRUM_LANGUAGE", "",
                         {QT_TRANSLATE_NOOP("errors", "\"%1\" is not the name of a language"),
                          qgetenv("FULCRUM_LANGUAGE").toStdString()},
                         {QT_TRANSLATE_NOOP("errors", "use one of: %1"), names_of(ui::languages)});
    ui::use_language(*language);
}

int run_command_line(const CommandTable& table, int& argc, char** argv, const MakeApplication& to_draw) {
    std::signal(SIGPIPE, SIG_IGN);  // run() reports a closed pipe
    const std::vector<std::string> words(argv + 1, argv + argc);
    std::optional<Invocation> call;
    std::exception_ptr refused;
    try {
        call = table.parse(words);
    } catch (const std::exception&) {
        refused = std::current_exception();
    }
    if (!call) {
        const QCoreApplication application(argc, argv);
        return guarded([&] {
            use_language_or(ui::Language::english);
            std::rethrow_exception(refused);
            return 0;
        });
    }
    if (!call->draws()) {
        const QCoreApplication application(argc, argv);
        set_plain_formats();
        return guarded([&] {
            use_language_or(ui::Language::english);
            if (call->command == nullptr) call = table.parse(words);  // its text, now in this language
            return run(*call);
        });
    }
    const std::unique_ptr<QCoreApplication> application = drawing_application(argc, argv, to_draw);
    set_plain_formats();
    return guarded([&] {
        use_language_or(ui::Language::english);
        return run(*call);
    });
}

}  // namespace fulcrum::app
