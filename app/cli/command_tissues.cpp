// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum tissues: what blades meet in a task's tissues at this site, and setting it.
#include <cstdlib>
#include <iostream>
#include <sstream>

#include "app/cli/commands.h"
#include "app/site_tissues.h"
#include "database/records/tissues.h"

namespace fulcrum::app {
namespace {

/// "areolar.penetrate_n=0.12,fat.penetrate_n=0.3" over what is in force.
database::TissueValues parse_values(const std::string& list, const ui::SiteTissues& site) {
    database::TissueValues values;
    for (const ui::SiteTissueValue& one : site.values) values[one.tissue][one.key] = one.value;
    std::stringstream parts(list);
    for (std::string part; std::getline(parts, part, ',');) {
        const std::size_t dot = part.find('.'), equals = part.find('=');
        char* end = nullptr;
        const double value = equals == std::string::npos ? 0 : std::strtod(part.c_str() + equals + 1, &end);
        if (dot == std::string::npos || equals == std::string::npos || dot > equals ||
            equals + 1 == part.size() || *end != '\0')
            throw UsageError("command line: --set: '" + part +
                             "' is no value; write TISSUE.KEY=NUMBER, as areolar.penetrate_n=0.12");
        values[part.substr(0, dot)][part.substr(dot + 1, equals - dot - 1)] = value;
    }
    return values;
}

nlohmann::json json_of(const std::string& task, const ui::SiteTissues& site,
                       const std::vector<database::TissueSetting>& history) {
    nlohmann::json values = nlohmann::json::array(), versions = nlohmann::json::array();
    for (const ui::SiteTissueValue& one : site.values)
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
    return {{"task", task},
            {"version", site.version},
            {"comparable", site.limits_note.empty()},
            {"why_not_comparable",
             site.limits_note.empty() ? nlohmann::json() : nlohmann::json(site.limits_note)},
            {"values", values},
            {"history", versions}};
}

}  // namespace

int command_tissues(const std::vector<std::string>& words) {
    OptionSpec spec;
    spec.usage =
        "usage: fulcrum tissues TASK [--set TISSUE.KEY=NUMBER,... | --scene-values] [--reason WORDS] [--db "
        "FILE] "
        "[--as LOGIN --password-file FILE] [--json]";
    spec.with_value = session_options();
    spec.with_value.insert({"--set", "--reason"});
    spec.flags = {"--scene-values", "--json"};
    spec.minimum_words = spec.maximum_words = 1;
    const Arguments arguments(words, spec);
    const bool sets = arguments.has("--set") || arguments.has("--scene-values");
    if (arguments.has("--set") && arguments.has("--scene-values"))
        throw UsageError("command line: --set: not together with --scene-values; " + spec.usage);
    if (arguments.has("--reason") && !sets)
        throw UsageError("command line: --reason: without --set or --scene-values nothing is set; " +
                         spec.usage);
    const std::string& task = arguments.words()[0];
    const database::Store store = open_store(arguments, false);
    const database::Session session = sets ? person_session(arguments, store) : session_of(arguments, store);
    if (sets) {
        store.require(session, database::Operation::set_tissues);
        const ui::SiteTissues before = site_tissues(store, session, task);
        set_site_tissues(store, session, task, before.version,
                         arguments.has("--set") ? parse_values(*arguments.value("--set"), before)
                                                : database::TissueValues(),
                         arguments.value_or("--reason", ""));
    }
    const ui::SiteTissues site = site_tissues(store, session, task);
    if (arguments.has("--json")) {
        print_json(json_of(task, site, database::Tissues(store).history(session, task)));
        return 0;
    }
    for (const ui::SiteTissueValue& one : site.values)
        std::cout << one.tissue << '.' << one.key << " = " << one.value << ' ' << one.unit << "  (scene "
                  << one.scene << ", " << one.range << ")  " << one.words << '\n';
    if (site.values.empty()) std::cout << task << " has no tissue that a blade cuts by its force\n";
    std::cout << "version " << site.version << (site.differ ? "" : ", the scene file's own") << '\n';
    if (!site.limits_note.empty()) std::cout << "not scored: " << site.limits_note << '\n';
    return 0;
}

}  // namespace fulcrum::app
