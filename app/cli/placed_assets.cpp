// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/placed_assets.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/installed_curriculum.h"
#include "database/records/curricula.h"

namespace fulcrum::app {

std::vector<database::PlacedAsset> place_assets(const database::Store& store) {
    return database::place_accepted_assets(
        store, {assets_folder(), all_installed_tasks(), load_forms(asset_path("forms"))});
}

void take_over_accepted(const database::Store& store) {
    for (const database::PlacedAsset& one : place_assets(store))
        if (one.refused) std::cerr << one.file.name << ": " << line_of(*one.refused) << '\n';
}

std::optional<Curriculum> newer_curriculum(const database::Store& store, const Curriculum& known) {
    if (!store.is_demo() && !store.is_server()) take_over_accepted(store);
    Curriculum now = installed_curriculum();
    const auto same = [](const Curriculum& a, const Curriculum& b) {
        return a.name() == b.name() && a.text == b.text;
    };
    if (same(now, known) &&
        std::equal(now.older.begin(), now.older.end(), known.older.begin(), known.older.end(), same))
        return std::nullopt;
    database::Curricula(store).check(now);
    return now;
}

void check_followed(const database::Store& store, const Curriculum& installed) {
    for (const database::MissingCurriculum& one : database::Curricula(store).check(installed))
        std::cerr << line_of(one.words()) << "; " << line_of(database::not_here_hint()) << '\n';
}

void print_placed(const std::vector<database::PlacedAsset>& placed) {
    for (const database::PlacedAsset& one : placed) {
        if (one.refused) {
            std::cout << one.file.name << " (sha256 " << one.file.digest
                      << "): not in force here: " << line_of(*one.refused) << '\n';
        } else {
            std::cout << one.file.name << " (sha256 " << one.file.digest << "): in force here, in "
                      << one.path << '\n';
        }
    }
}

nlohmann::json placed_json(const std::vector<database::PlacedAsset>& placed) {
    nlohmann::json rows = nlohmann::json::array();
    for (const database::PlacedAsset& one : placed)
        rows.push_back({{"file", one.file.name},
                        {"sha256", one.file.digest},
                        {"path", one.path},
                        {"refused", one.refused ? nlohmann::json(one.refused->words()) : nlohmann::json()}});
    return rows;
}

}  // namespace fulcrum::app
