// SPDX-License-Identifier: GPL-3.0-or-later
// Which scenes, tasks, benchmark sets and curricula an assessed attempt may be performed with: those whose
// digest is compiled into the program, and those that an educator of the programme has accepted, which is
// audited. Where the files lie is the environment's business (FULCRUM_ASSETS); what they say is not.
#pragma once

#include <string>
#include <vector>

#include "database/rows/attempt_records.h"
#include "database/store/store.h"

namespace fulcrum::database {

/// Files as they were when the program was built (cmake/asset_digests.cmake), by name.
const std::vector<AssetFile>& delivered_assets();

struct AcceptedAsset {
    AssetFile file;
    std::string person_name, reason;
    UtcMilliseconds time = 0;
};

/// By its name: a curriculum or a benchmark set, whose contents the programme's other stations get.
bool is_passed_on(const AssetFile& file);

/// What an accepted file says.
struct AcceptedText {
    AssetFile file;
    UtcMilliseconds time = 0;  ///< of the acceptance
    std::string text;          ///< not compared with the digest yet
};

class AcceptedAssets {
  public:
    explicit AcceptedAssets(const Store& store) : store_(store) {}
    /// Those of `files` that are neither delivered nor accepted.
    std::vector<AssetFile> unknown(const std::vector<AssetFile>& files) const;
    /// Whether accept() with its text would add anything.
    bool is_to_accept(const AssetFile& file) const;
    /// Newest first. Operation::read_tissues' readers may know: it names no trainee.
    std::vector<AcceptedAsset> list() const;
    /// From now on attempts with this file can be assessed. `text`: what it says, kept of curricula and
    /// benchmark sets, so that the programme's other stations get it (database/scoring/asset_placing.h).
    /// Where such a file is accepted, under whichever name, and its text is not kept, the text is added.
    /// `takes_over`: in words, which limits become the site's own with a benchmark set; audited. Throws
    /// StoreError bad_value without a reason, conflict where there is nothing to add.
    /// Operation::accept_assets.
    void accept(const Session& educator, const AssetFile& file, const std::string& reason,
                const std::string& text = {}, const std::string& takes_over = {}) const;
    /// Accepted files whose text is kept, oldest first.
    std::vector<AcceptedText> texts() const;

  private:
    const Store& store_;
};

/// Why attempts with these files are practice only, a sentence with each file, its digest and what to do.
Sentence practice_only_words(const std::vector<AssetFile>& unknown);

}  // namespace fulcrum::database
