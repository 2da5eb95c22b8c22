// SPDX-License-Identifier: GPL-3.0-or-later
// Curricula and benchmark sets that an educator put in force at another station of the programme: their
// contents come with an exchange (asset_text), and this puts them into the assets folder of this station.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/curriculum/remedy.h"
#include "assessment/forms/observer_form.h"
#include "database/store/accepted_assets.h"

namespace fulcrum::database {

/// Where files are put, and what a curriculum has to fit.
struct AssetPlace {
    std::string folder;  ///< the assets folder
    std::vector<InstalledTask> tasks;
    std::vector<ObserverForm> forms;
};

/// What became of an accepted file that was not in place.
struct PlacedAsset {
    AssetFile file;
    std::string path;
    std::optional<Sentence> refused;  ///< why it was not put there; empty: it is there now
};

/// The name that the stations give a file with these contents: "benchmarks/A2.json",
/// "curricula/rectal-1001.json". Empty: it is neither a benchmark set nor a curriculum.
std::string passed_on_name(const std::string& text);

/// A version of a curriculum is put there where the folder has no file of its name; a benchmark set takes the
/// place of one with a lower version, which is kept in the folder "superseded". Of several of one version the
/// one that was accepted first counts, and before one that nobody accepted, such as the program's own; a
/// curriculum that is in place already stays, and is named. A set with a higher version stays. Attempts that
/// have begun keep what they began with; curricula count from the next start of a window, or when an exchange
/// ends in it, its page of the curriculum is opened, or somebody who follows one that it lacks signs in.
/// Empty where nothing had to be done. Throws StoreError.
std::vector<PlacedAsset> place_accepted_assets(const Store& store, const AssetPlace& place);

}  // namespace fulcrum::database
