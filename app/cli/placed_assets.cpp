// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/placed_assets.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/installed_curriculum.h"

namespace fulcrum::app {

std::vector<database::PlacedAsset> place_assets(const database::Store& store) {
    return database::place_accepted_assets(
        store, {assets_folder(), all_installed_tasks(), load_forms(asset_path("forms"))});
}

bool take_over_accepted(const database::Store& store) {
    bool new_curriculum = false;
    for (const database::PlacedAsset& one : place_assets(store)) {
        new_curriculum = new_curriculum || (!one.refused && one.file.name.rfind("curricula/", 0) == 0);
        if (one.refused) std::cerr << one.file.name << ": " << line_of(*one.refused) << '\n';
    }
    return new_curriculum;
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
