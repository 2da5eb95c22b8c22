// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum tissues: the site's cutting parameters of a task's tissues.
#include <iostream>
#include <sstream>

#include "app/cli/commands.h"
#include "assessment/metrics/statement_words.h"
#include "database/records/tissues.h"
#include "database/scoring/site_tissues.h"
#include "sim_core/numerics/number_text.h"

namespace fulcrum::app {
namespace {

/// Applies "areolar.penetrate_n=0.12,fat.penetrate_n=0.3" to the values in force.
database::TissueValues parse_values(const std::string& list, const SiteTissues& site) {
    database::TissueValues values;
    for (const SiteTissueValue& one : site.values) values[one.tissue][one.key] = one.value;
    std::stringstream parts(list);
    for (std::string part; std::getline(parts, part, ',');) {
        const std::size_t dot = part.find('.'), equals = part.find('=');
        const bool complete = dot != std::string::npos && equals != std::string::npos && dot < equals;
        const auto value = complete ? parse_decimal(part.substr(equals + 1)) : std::nullopt;
        if (!value)
            throw UsageError(
                "--set", {QT_TRANSLATE_NOOP("errors", "'%1' is not a value"), part},
                QT_TRANSLATE_NOOP("errors", "write TISSUE.KEY=NUMBER, for example areolar.penetrate_n=0.12"));
        values[part.substr(0, dot)][part.substr(dot + 1, equals - dot - 1)] = *value;
    }
    return values;
}

nlohmann::json json_of(const std::string& task, const SiteTissues& site,
                       const std::vector<database::TissueSetting>& history) {
    nlohmann::json values = nlohmann::json::array(), versions = nlohmann::json::array(),
                   notes = nlohmann::json::array();
    for (const SiteTissueValue& one : site.values)
        values.push_back({{"tissue", one.tissue},
                          {"key", one.key},
                          {"unit", one.unit},
                          {"scene", one.scene},
                          {"value", one.value},
                          {"range", one.range}});
    for (const database::TissueSetting& one : history)
        versions.push_back({{"version", one.version},
                            {"time", database::iso_utc(one.time)},
                            {"by", one.author_name},
                            {"reason", one.reason},
                            {"values", one.values}});
    for (const LimitsNote& one : site.limits_notes)
        notes.push_back({{"device_class", row_of(device_classes, one.device_class).name},
                         {"why_not_comparable", words_of(one.why)}});
    return {{"task", task},
            {"version", site.version},
            {"comparable", site.unusable.empty() && site.limits_notes.empty()},
            {"not_comparable_classes", notes},
            {"values", values},
            {"history", versions},
            {"unusable", or_null(site.unusable.words())}};
}

int run_tissues(const Arguments& arguments) {
    arguments.exclude("--set", "--scene-values");
    const bool sets = arguments.has("--set") || arguments.has("--scene-values");
    if (arguments.has("--reason") && !sets)
        throw UsageError("--reason", QT_TRANSLATE_NOOP("errors", "there is no change to give a reason for"),
                         QT_TRANSLATE_NOOP("errors", "add --set or --scene-values"));
    const std::string& task = arguments.words()[0];
    const database::Store store = open_store(arguments, false);
    const database::Session session = sets ? person_session(arguments, store) : session_of(arguments, store);
    if (sets) {
        store.require(session, database::Operation::set_tissues);
        const SiteTissues before = site_tissues(store, session, task);
        set_site_tissues(store, session, task, before.version,
                         arguments.has("--set") ? parse_values(*arguments.value("--set"), before)
                                                : database::TissueValues(),
                         arguments.value_or("--reason", ""));
    }
    const SiteTissues site = site_tissues(store, session, task);
    if (arguments.has("--json")) {
        print_json(json_of(task, site, database::Tissues(store).history(session, task)));
        return 0;
    }
    for (const SiteTissueValue& one : site.values)
        std::cout << one.tissue << '.' << one.key << " = " << one.value << ' ' << one.unit << "  (scene "
                  << one.scene << ", " << one.range << ")  " << one.words << '\n';
    if (!site.unusable.empty())
        std::cout << "no attempt can begin with these values: " << site.unusable.words()
                  << " (--scene-values resets them)\n";
    if (site.values.empty()) std::cout << task << " has no tissue with cutting parameters\n";
    std::cout << "version " << site.version << (site.differ ? "" : ", equal to the scene file") << '\n';
    for (const LimitsNote& one : site.limits_notes)
        std::cout << "not scored (" << row_of(device_classes, one.device_class).name
                  << "): " << words_of(one.why) << '\n';
    return 0;
}

}  // namespace

Command tissues_command() {
    return {
        "tissues",
        "TASK",
        1,
        1,
        QT_TRANSLATE_NOOP("commands", "Shows or sets the site's cutting parameters of a task's tissues."),
        joined(
            {{"--set", "LIST",
              QT_TRANSLATE_NOOP(
                  "commands",
                  "New values: TISSUE.KEY=NUMBER, separated by commas. Numbers have a decimal point.")},
             {"--scene-values", "", QT_TRANSLATE_NOOP("commands", "Restore the values of the scene file.")},
             {"--reason", "TEXT", QT_TRANSLATE_NOOP("commands", "The reason; recorded in the audit log.")}},
            session_options()),
        run_tissues};
}

}  // namespace fulcrum::app
