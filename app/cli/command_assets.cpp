// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum assets: which scenes, tasks, benchmark sets and curricula assessed attempts accept, and adding one.
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "app/cli/commands.h"
#include "app/cli/placed_assets.h"
#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum.h"
#include "assessment/scoring/benchmark.h"
#include "database/rows/crypto.h"
#include "database/store/accepted_assets.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum::app {
namespace {

namespace files = std::filesystem;
using database::AcceptedAsset;
using database::AcceptedAssets;
using database::AssetFile;

std::string text_at(const files::path& path) {
    return read_text_file(path.string(), JsonLimits().bytes);
}
/// With its folder.
std::string name_at(const files::path& path) {
    return path.parent_path().filename().string() + "/" + path.filename().string();
}
AssetFile asset_at(const files::path& path) {
    return {name_at(path), database::sha256_hex(text_at(path))};
}
/// A set or a curriculum that is accepted before it is in the assets folder has the name that it will have
/// there: by its name the stations pass it on.
std::string accepted_name(const files::path& path, const std::string& text) {
    const bool is_in_curricula = path.parent_path().filename() == "curricula";  // the newest may be ID.json
    const std::string name = is_in_curricula ? std::string() : database::passed_on_name(text);
    return name.empty() ? name_at(path) : name;
}

/// The files of the assets folder that decide a result, by name.
std::vector<AssetFile> installed_assets() {
    std::vector<AssetFile> found;
    for (const char* folder : {"benchmarks", "curricula", "scenes", "tasks"}) {
        const files::path path = asset_path(folder);
        if (!files::is_directory(path)) continue;
        for (const auto& entry : files::directory_iterator(path))
            if (entry.path().extension() == ".json") found.push_back(asset_at(entry.path()));
    }
    std::sort(found.begin(), found.end(),
              [](const AssetFile& a, const AssetFile& b) { return a.name < b.name; });
    return found;
}

enum class Standing { delivered, accepted, unknown };
constexpr const char* standing_names[] = {"delivered", "accepted", "unknown"};

Standing standing_of(const AssetFile& file, const AcceptedAssets& assets,
                     const std::vector<AcceptedAsset>& accepted) {
    if (!assets.unknown({file}).empty()) return Standing::unknown;
    const bool named = std::any_of(accepted.begin(), accepted.end(),
                                   [&](const AcceptedAsset& one) { return one.file.digest == file.digest; });
    return named ? Standing::accepted : Standing::delivered;
}

int list(const Arguments& arguments) {
    const database::Store store = open_store(arguments, false, true);
    const AcceptedAssets assets(store);
    const std::vector<AcceptedAsset> accepted = assets.list();
    nlohmann::json rows = nlohmann::json::array(), deeds = nlohmann::json::array();
    for (const AssetFile& file : installed_assets()) {
        const char* standing = standing_names[static_cast<int>(standing_of(file, assets, accepted))];
        rows.push_back({{"file", file.name}, {"sha256", file.digest}, {"standing", standing}});
        if (!arguments.has("--json"))
            std::cout << file.digest << "  " << file.name << "  " << standing << '\n';
    }
    for (const AcceptedAsset& one : accepted) {
        deeds.push_back({{"file", one.file.name},
                         {"sha256", one.file.digest},
                         {"by", one.person_name},
                         {"time", database::iso_utc(one.time)},
                         {"reason", one.reason}});
        if (!arguments.has("--json"))
            std::cout << "accepted " << database::iso_utc(one.time) << " by " << one.person_name << ": "
                      << one.file.name << " (" << one.reason << ")\n";
    }
    if (arguments.has("--json"))
        print_json({{"folder", assets_folder()}, {"files", rows}, {"accepted", deeds}});
    return 0;
}

/// What becomes of the provisional limits of a set's task. Of a task that is not installed here: what the set
/// says.
TakenOver limits_of_site(const BenchmarkSet& set) {
    const std::vector<std::string> tasks = task_ids();
    if (std::find(tasks.begin(), tasks.end(), set.task) == tasks.end()) return {set.taken_over, {}};
    return taken_over(load_task(task_file(set.task)), set);
}

nlohmann::json left_json(const std::vector<LeftProvisional>& left) {
    nlohmann::json rows = nlohmann::json::array();
    for (const LeftProvisional& one : left) {
        rows.push_back(taken_over_to_json({one.now})[0]);
        rows.back()["taken_over"] = one.taken_over ? nlohmann::json(one.taken_over->limit) : nlohmann::json();
    }
    return rows;
}

void print_limits_of_site(const TakenOver& limits) {
    if (!limits.by_site.empty())
        std::cout << "takes over as limits of this site: " << provisional_words(limits.by_site) << '\n';
    for (const LeftProvisional& one : limits.left) {
        std::cout << "still provisional: " << provisional_words(one.now);
        if (one.taken_over)
            std::cout << " (changed since the set took it over: " << provisional_words(*one.taken_over)
                      << "; build the set again)";
        std::cout << '\n';
    }
}

int accept(const Arguments& arguments) {
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    store.require(session, database::Operation::accept_assets);
    const files::path path = files::absolute(arguments.words()[0]);
    const std::string text = text_at(path);
    const AssetFile file{accepted_name(path, text), database::sha256_hex(text)};
    // A set that cannot be read here is not accepted either: nobody could say what it takes over. Nor is a
    // curriculum, or one with a rule that nobody can meet.
    std::optional<TakenOver> limits;
    const std::string kind = database::passed_on_name(text);
    if (kind.rfind("benchmarks/", 0) == 0) limits = limits_of_site(parse_benchmark(text, path.string()));
    if (kind.rfind("curricula/", 0) == 0) {
        Curriculum curriculum = parse_draft(text, path.string());
        curriculum.file = path.string();
        check_rules(curriculum);
    }
    AcceptedAssets(store).accept(session, file, arguments.value_or("--reason", ""), text,
                                 limits ? provisional_words(limits->by_site) : std::string());
    if (arguments.has("--json")) {
        nlohmann::json document = {{"file", file.name}, {"sha256", file.digest}};
        if (limits) {
            document["takes_over"] = taken_over_to_json(limits->by_site);
            document["left_provisional"] = left_json(limits->left);
        }
        print_json(document);
    } else {
        std::cout << "accepted " << file.name << " (sha256 " << file.digest << ")\n";
        if (limits) print_limits_of_site(*limits);
    }
    return 0;
}

int place(const Arguments& arguments) {
    const database::Store store = open_store(arguments, false, true);
    const std::vector<database::PlacedAsset> placed = place_assets(store);
    if (arguments.has("--json")) {
        print_json({{"folder", assets_folder()}, {"placed", placed_json(placed)}});
    } else if (placed.empty()) {
        std::cout << "every accepted curriculum and benchmark set, or a newer one, is in place already\n";
    } else {
        print_placed(placed);
    }
    return std::all_of(placed.begin(), placed.end(),
                       [](const database::PlacedAsset& one) { return !one.refused; })
               ? 0
               : 1;
}

}  // namespace

std::vector<Command> asset_commands() {
    return {
        {"assets list",
         "",
         0,
         0,
         QT_TRANSLATE_NOOP("commands",
                           "Lists the installed scenes, tasks, benchmark sets and curricula, and which of "
                           "them assessed attempts accept."),
         {store_option(), json_option()},
         list},
        {"assets accept", "FILE", 1, 1,
         QT_TRANSLATE_NOOP(
             "commands",
             "Accepts a file of the site, such as a benchmark set from its experts, for assessed attempts."),
         joined(
             {{"--reason", "TEXT", QT_TRANSLATE_NOOP("commands", "The reason; recorded in the audit log.")}},
             session_options()),
         accept},
        {"assets place",
         "",
         0,
         0,
         QT_TRANSLATE_NOOP(
             "commands",
             "Puts curricula and benchmark sets that educators put in force at other stations "
             "into the assets folder (`fulcrum sync` and the start of the window do the same)."),
         {store_option(), json_option()},
         place}};
}

}  // namespace fulcrum::app
