// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum certificate: writes the certificate of a completed stage, or verifies a check code.
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/attempt_document.h"
#include "app/cli/installed_curriculum.h"
#include "app/cli/placed_assets.h"
#include "app/services/application.h"
#include "app/services/program.h"
#include "assessment/assets/assets.h"
#include "database/records/certificates.h"
#include "database/rows/attempt_records.h"
#include "ui/reports/certificate.h"

namespace fulcrum::app {
namespace {

Curriculum curriculum(const database::Store& store) {
    Curriculum installed = installed_curriculum();
    check_followed(store, installed);
    return installed;
}

int verify(const Arguments& arguments, const database::Store& store, const database::Session& session) {
    const auto found =
        database::find_certificate(store, session, *arguments.value("--verify"), curriculum(store));
    if (arguments.has("--json")) {
        nlohmann::json document = {{"valid", found.has_value()}};
        if (found)
            document.update({{"code", found->code},
                             {"person", found->person_name},
                             {"curriculum", found->curriculum},
                             {"follows", found->follows},
                             {"stage", found->stage},
                             {"completed", database::iso_utc(found->completed_at)}});
        print_json(document);
    } else if (found) {
        std::cout << "valid: " << found->person_name << ", stage " << found->stage << " ("
                  << found->stage_title << ") of " << found->curriculum << ", completed "
                  << database::iso_utc(found->completed_at)
                  << (found->follows == found->curriculum ? "" : ", follows " + found->follows + " now")
                  << '\n';
    } else {
        std::cout << "not valid: no certificate with this code is in force among the people whose progress "
                     "you may read\n";
    }
    return found ? 0 : 1;
}

int write(const Arguments& arguments, const database::Store& store, const database::Session& session) {
    if (!arguments.has("--stage"))
        throw UsageError("--stage", QT_TRANSLATE_NOOP("errors", "is missing"),
                         QT_TRANSLATE_NOOP("errors", "name the stage: --stage A"));
    if (!arguments.has("--output"))
        throw UsageError("--output", QT_TRANSLATE_NOOP("errors", "is missing"),
                         QT_TRANSLATE_NOOP("errors", "name the file to write: -o FILE"));
    const std::string person = person_named(arguments, store, session);
    const std::string stage = *arguments.value("--stage"), path = *arguments.value("--output");
    std::vector<database::Certificate> made =
        database::certificates(store, session, person, curriculum(store));
    // Of a stage that was completed under several versions the latest.
    std::reverse(made.begin(), made.end());
    for (const database::Certificate& one : made) {
        if (one.stage != stage || arguments.value_or("--curriculum", one.curriculum) != one.curriculum)
            continue;
        std::vector<TaskDefinition> tasks;
        for (const std::string& id : task_ids()) tasks.push_back(load_task(task_file(id)));
        ui::write_certificate(store, session, one, tasks, version_line(), path);
        if (arguments.has("--json")) {
            print_json({{"files", {path}}, {"code", one.code}, {"curriculum", one.curriculum}});
        } else {
            std::cout << "wrote " << path << " (" << one.curriculum << "), check code " << one.code << '\n';
        }
        return 0;
    }
    throw InputError(
        "--stage", stage, QT_TRANSLATE_NOOP("errors", "this person has not completed the stage"),
        QT_TRANSLATE_NOOP(
            "errors",
            "a certificate needs proficiency in every task of the stage; provisional limits give none"));
}

int run_certificate(const Arguments& arguments) {
    if (arguments.has("--verify") + arguments.has("--person") != 1)
        throw UsageError("certificate",
                         QT_TRANSLATE_NOOP("errors", "needs exactly one of --verify and --person"),
                         QT_TRANSLATE_NOOP("errors", "give one of them"));
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    return arguments.has("--verify") ? verify(arguments, store, session) : write(arguments, store, session);
}

}  // namespace

Command certificate_command() {
    return {"certificate",
            "",
            0,
            0,
            QT_TRANSLATE_NOOP(
                "commands",
                "Writes the certificate of a completed stage, or verifies its check code; needs --as."),
            joined({{"--verify", "CODE",
                     QT_TRANSLATE_NOOP("commands", "Says whether a certificate with this code is in force.")},
                    {"--person", "LOGIN", QT_TRANSLATE_NOOP("commands", "The certificate of this person.")},
                    {"--stage", "ID", QT_TRANSLATE_NOOP("commands", "The completed stage, for example A.")},
                    {"--curriculum", "VERSION",
                     QT_TRANSLATE_NOOP("commands",
                                       "Of the stage as completed under this version, for example rectal@1, "
                                       "where there are several; without it the latest.")},
                    {"--output", "FILE", QT_TRANSLATE_NOOP("commands", "The PDF to write."), "", {}, "-o"}},
                   session_options()),
            run_certificate,
            true};
}

}  // namespace fulcrum::app
