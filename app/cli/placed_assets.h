// SPDX-License-Identifier: GPL-3.0-or-later
// Curricula and benchmark sets of the programme's other stations, put into this station's assets folder: by
// `fulcrum assets place`, after `fulcrum sync`, and when a window opens its store.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "assessment/curriculum/curriculum.h"
#include "database/scoring/asset_placing.h"

namespace fulcrum::app {

/// Into the assets folder in use. Throws StoreError, InputError (a task or a form there is not valid).
std::vector<database::PlacedAsset> place_assets(const database::Store& store);
/// At the start of a window: what `fulcrum sync` could not write, for instance. What is refused is named on
/// standard error. Throws as place_assets().
void take_over_accepted(const database::Store& store);
/// The curriculum that is in force by now, where it is another one than `known`: published by another program
/// of this station, or brought by an exchange, which is taken over as above. Throws StoreError, InputError.
std::optional<Curriculum> newer_curriculum(const database::Store& store, const Curriculum& known);
/// Names on standard error the versions that people follow and that are not at this station. Throws
/// InputError where the file of one was edited.
void check_followed(const database::Store& store, const Curriculum& installed);
/// A line for each.
void print_placed(const std::vector<database::PlacedAsset>& placed);
/// file, sha256, path, refused (null: it is in place).
nlohmann::json placed_json(const std::vector<database::PlacedAsset>& placed);

}  // namespace fulcrum::app
