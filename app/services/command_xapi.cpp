// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum xapi: statements for a learning record store are queued in the store and sent from there.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/installed_curriculum.h"
#include "app/services/application.h"
#include "app/services/program.h"
#include "assessment/assets/assets.h"
#include "assessment/task/task.h"
#include "database/records/people.h"
#include "database/xapi/record_store.h"
#include "sim_core/numerics/files.h"
#include "ui/reports/report.h"
#include "ui/reports/report_xapi.h"

namespace fulcrum::app {
namespace {

using database::OutboxCounts;
using database::OutboxStatement;

std::string record_store_of(const Arguments& arguments) {
    const auto to = arguments.value("--to");
    if (!to)
        throw UsageError("--to", QT_TRANSLATE_NOOP("errors", "is missing"),
                         QT_TRANSLATE_NOOP("errors", "name the record store: --to https://lrs.example/xapi"));
    return database::record_store_address(*to);
}

/// KEY:SECRET from a file that only its owner can read.
std::string credentials_of(const Arguments& arguments) {
    const auto path = arguments.value("--credentials");
    if (!path) return {};
    const auto fail = [&](const Sentence& problem, const Sentence& hint) {
        throw InputError(*path, "", problem, hint);
    };
    const int file = ::open(path->c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (file < 0)
        fail(QT_TRANSLATE_NOOP("errors", "the file of the credentials cannot be read"),
             QT_TRANSLATE_NOOP("errors", "make it, one line KEY:SECRET, with `chmod 600`"));
    struct stat about {};
    std::string line(1001, '\0');
    const bool known = ::fstat(file, &about) == 0;
    const ssize_t size = known && S_ISREG(about.st_mode) ? ::read(file, line.data(), line.size()) : -1;
    ::close(file);
    if (!known || !S_ISREG(about.st_mode) || (about.st_mode & 077) != 0 || about.st_uid != ::geteuid())
        fail(QT_TRANSLATE_NOOP("errors", "others can read the file of the credentials, or it is not yours"),
             QT_TRANSLATE_NOOP("errors", "run `chmod 600` on it"));
    line.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
    line = line.substr(0, line.find_first_of("\r\n"));
    const std::size_t colon = line.find(':');
    if (line.size() > 1000 || colon == 0 || colon == std::string::npos || colon + 1 == line.size())
        fail(QT_TRANSLATE_NOOP("errors", "the file of the credentials does not hold KEY:SECRET"),
             QT_TRANSLATE_NOOP("errors", "write one line: the key, a colon, the secret"));
    return line;
}

/// The people whose statements are to be queued.
std::vector<ui::PersonReport> people_of(const Arguments& arguments, const database::Store& store,
                                        const database::Session& session) {
    std::vector<TaskDefinition> tasks;
    for (const std::string& id : task_ids()) tasks.push_back(load_task(task_file(id)));
    if (arguments.has("--person"))
        return {ui::gather_person(store, session, person_named(arguments, store, session), tasks,
                                  version_line())};
    const std::string name = *arguments.value("--cohort");
    const auto cohort = database::People(store).find_cohort(session, name);
    if (!cohort)
        throw InputError("--cohort", "",
                         {QT_TRANSLATE_NOOP("errors", "no cohort '%1' that you may read"), name},
                         QT_TRANSLATE_NOOP("errors", "name a cohort of this store"));
    return *ui::gather_people(store, session, cohort->id, tasks, version_line());
}

int queue(const Arguments& arguments, const database::Store& store, const database::Session& session,
          const database::XapiOutbox& outbox) {
    arguments.exclude("--person", "--cohort");
    if (!arguments.has("--person") && !arguments.has("--cohort")) return 0;
    if (store.is_demo())
        throw InputError("--db", "", QT_TRANSLATE_NOOP("errors", "the demonstration is never sent anywhere"),
                         QT_TRANSLATE_NOOP("errors", "name the store of the programme"));
    const std::string home_page = arguments.value_or("--home-page", "");
    ui::require_home_page(home_page);
    std::vector<OutboxStatement> statements;
    for (const ui::PersonReport& person : people_of(arguments, store, session)) {
        if (person.synthetic) continue;
        ui::each_xapi_statement(person, home_page, [&](ui::XapiStatement&& made) {
            OutboxStatement one;
            one.id = std::move(made.id);
            one.person_id = person.person_id;
            one.attempt_id = std::move(made.attempt_id);
            one.text = std::move(made.text);
            statements.push_back(std::move(one));
        });
    }
    return outbox.add(statements);
}

nlohmann::json counts_json(const OutboxCounts& counts) {
    return {{"record_store", counts.endpoint},
            {"waiting", counts.waiting},
            {"done", counts.done},
            {"quarantined", counts.quarantined},
            {"next_try", counts.waiting == 0 || counts.next_try == 0
                             ? nlohmann::json()
                             : nlohmann::json(database::iso_utc(counts.next_try))}};
}

void print_counts(const OutboxCounts& counts) {
    std::cout << counts.endpoint << ": " << counts.waiting << " waiting, " << counts.done << " done, "
              << counts.quarantined << " quarantined\n";
}

int run_send(const Arguments& arguments) {
    const std::string endpoint = record_store_of(arguments), credentials = credentials_of(arguments);
    const int timeout_ms = static_cast<int>(1000 * arguments.integer("--timeout", 20, 1, 600));
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const database::XapiOutbox outbox(store, session, endpoint);
    const int queued = queue(arguments, store, session, outbox);
    const int again = arguments.has("--again") ? outbox.release() : 0;
    database::RecordStore record_store(endpoint, credentials, timeout_ms);
    const database::SendResult result = database::send_waiting(outbox, record_store);
    const OutboxCounts counts = outbox.counts();
    if (arguments.has("--json")) {
        nlohmann::json document = counts_json(counts);
        document.update({{"queued", queued},
                         {"again", again},
                         {"sent", result.sent},
                         {"known", result.known},
                         {"newly_quarantined", result.quarantined},
                         {"postponed", result.postponed},
                         {"complete", result.complete}});
        print_json(document);
    } else {
        std::cout << queued << " queued, " << result.sent << " sent, " << result.known << " known already, "
                  << result.quarantined << " quarantined, " << result.postponed << " postponed\n";
        print_counts(counts);
        if (!result.complete)
            std::cout << "the record store could not be reached; nothing is lost, send again later\n";
    }
    return result.complete && counts.waiting == 0 && counts.quarantined == 0 ? 0 : 1;
}

int run_list(const Arguments& arguments) {
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    nlohmann::json stores = nlohmann::json::array();
    for (const OutboxCounts& counts : database::outbox_counts(store, session)) {
        stores.push_back(counts_json(counts));
        nlohmann::json problems = nlohmann::json::array();
        const auto quarantined = database::XapiOutbox(store, session, counts.endpoint).quarantined();
        for (const OutboxStatement& one : quarantined)
            problems.push_back({{"id", one.id}, {"problem", one.problem}});
        stores.back()["problems"] = problems;
        if (arguments.has("--json")) continue;
        print_counts(counts);
        for (const OutboxStatement& one : quarantined)
            std::cout << "  quarantined " << one.id << ": " << one.problem << '\n';
    }
    if (arguments.has("--json")) print_json({{"record_stores", stores}});
    return 0;
}

int run_profile(const Arguments& arguments) {
    const auto output = arguments.value("--output");
    if (output)
        write_whole_file(*output, xapi_profile_text);
    else
        std::cout << xapi_profile_text;
    return 0;
}

}  // namespace

std::vector<Command> xapi_commands() {
    return {
        {"xapi send", "", 0, 0,
         QT_TRANSLATE_NOOP("commands",
                           "Sends statements on attempts and ratings to a learning record store."),
         joined(
             {{"--to", "ADDRESS",
               QT_TRANSLATE_NOOP("commands", "The record store, such as https://lrs.example/xapi.")},
              {"--credentials", "FILE",
               QT_TRANSLATE_NOOP(
                   "commands", "A file with one line KEY:SECRET that only its owner can read (chmod 600).")},
              {"--cohort", "NAME",
               QT_TRANSLATE_NOOP("commands", "Queue the statements of this cohort first.")},
              {"--person", "LOGIN",
               QT_TRANSLATE_NOOP("commands", "Queue the statements of this person first.")},
              {"--home-page", "ADDRESS",
               QT_TRANSLATE_NOOP("commands", "The web address that the ids of your people belong to.")},
              {"--again", "", QT_TRANSLATE_NOOP("commands", "Try what is quarantined once more.")},
              {"--timeout", "S", QT_TRANSLATE_NOOP("commands", "How long an answer may take."), "20"}},
             session_options()),
         run_send, true,
         QT_TRANSLATE_NOOP("commands",
                           "A director signs in with --as. Without --cohort and --person what waits is sent. "
                           "Each statement has its id for good, so that it can be cut off and repeated at "
                           "any time. Exit status 1 while statements wait or are quarantined.")},
        {"xapi list", "", 0, 0,
         QT_TRANSLATE_NOOP("commands", "Lists how many statements wait, are done or quarantined, and why."),
         session_options(), run_list},
        {"xapi profile",
         "",
         0,
         0,
         QT_TRANSLATE_NOOP("commands",
                           "Writes the xAPI profile of the statements: their terms and kinds, as JSON-LD."),
         {{"--output", "FILE", QT_TRANSLATE_NOOP("commands", "Write it to this file."), "", {}, "-o"}},
         run_profile}};
}

}  // namespace fulcrum::app
