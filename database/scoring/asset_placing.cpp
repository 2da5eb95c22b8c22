// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/asset_placing.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "assessment/curriculum/curriculum.h"
#include "assessment/curriculum/rating_rule.h"
#include "assessment/scoring/benchmark.h"
#include "database/rows/crypto.h"
#include "database/scoring/benchmark_files.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/output_file.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum::database {
namespace {

namespace fs = std::filesystem;

/// A file that is to be in place, and its version.
struct Wanted {
    const AcceptedText* accepted = nullptr;
    int version = 0;
};

class Placing {
  public:
    Placing(const Store& store, const AssetPlace& place) : place_(place), accepted_(store) {
        for (const InstalledTask& task : place.tasks) tasks_.push_back(task.id);
    }
    std::vector<PlacedAsset> run() {
        std::vector<AcceptedText> texts = accepted_.texts();  // oldest first
        for (AcceptedText& one : texts) {
            // Accepted from another folder, and its contents were added later.
            if (is_passed_on(one.file)) continue;
            const std::string name = passed_on_name(one.text);
            if (!name.empty()) one.file.name = name;
        }
        std::map<std::string, Wanted> wanted;  // by name
        for (const AcceptedText& one : texts) {
            const std::optional<int> version = version_of(one);
            if (!version) continue;
            Wanted& best = wanted[one.file.name];
            // Of one version the first that was accepted.
            if (best.accepted == nullptr || *version > best.version) best = {&one, *version};
        }
        // In the order of versions, so that a curriculum follows the one before it.
        std::vector<Wanted> list;
        for (const auto& [name, one] : wanted) list.push_back(one);
        std::stable_sort(list.begin(), list.end(),
                         [](const Wanted& a, const Wanted& b) { return a.version < b.version; });
        for (const Wanted& one : list) place_one(one);
        return std::move(placed_);
    }

  private:
    std::string path_of(const AssetFile& file) const {
        return (fs::path(place_.folder) / file.name).string();
    }
    void refuse(const AssetFile& file, Sentence why) {
        placed_.push_back({file, path_of(file), std::move(why)});
    }

    bool is_in_place(const AssetFile& file) const {
        try {
            std::error_code error;
            return fs::exists(path_of(file), error) &&
                   sha256_hex(read_text_file(path_of(file), JsonLimits().bytes)) == file.digest;
        } catch (const InputError&) {
            return false;  // it cannot be read
        }
    }

    /// Of a text that says what its acceptance says, under the name that such a file has; else it is refused.
    std::optional<int> version_of(const AcceptedText& one) {
        if (sha256_hex(one.text) != one.file.digest) {
            refuse(one.file, {QT_TRANSLATE_NOOP("errors", "its contents are not those that were accepted")});
            return std::nullopt;
        }
        try {
            std::string name;
            int version = 0;
            if (one.file.name.rfind("curricula/", 0) == 0) {
                const Curriculum curriculum = parse_curriculum(one.text, one.file.name, tasks_);
                check_ratings(curriculum, place_.forms);
                check_remedies(curriculum, place_.tasks);
                version = curriculum.version;
                name = "curricula/" + curriculum.id + "-" + std::to_string(version) + ".json";
            } else {
                const BenchmarkSet set = parse_benchmark(one.text, one.file.name);
                version = set.version;
                name = "benchmarks/" + benchmark_name(set.key()) + ".json";
            }
            if (name == one.file.name && name.find("..") == std::string::npos) return version;
            refuse(one.file, {QT_TRANSLATE_NOOP("errors", "such a file has the name %1"), name});
        } catch (const InputError& problem) {
            // In place already, and this program no longer reads it: no news.
            if (!is_in_place(one.file)) refuse(one.file, problem.sentence());
        }
        return std::nullopt;
    }

    /// Of a file in place; nothing: nobody accepted it, it came with the program for instance.
    std::optional<bool> is_accepted_before(const std::string& digest, const AcceptedText& than) const {
        for (const AcceptedAsset& one : accepted_.list())
            if (one.file.digest == digest)
                return std::tie(one.time, digest) < std::tie(than.time, than.file.digest);
        return std::nullopt;
    }

    void place_one(const Wanted& wanted) {
        const AcceptedText& one = *wanted.accepted;
        const fs::path path = path_of(one.file);
        const bool is_set = one.file.name.rfind("benchmarks/", 0) == 0;
        try {
            int before = 0;
            if (fs::exists(path)) {
                const std::string text = read_text_file(path.string(), JsonLimits().bytes);
                const std::string digest = sha256_hex(text);
                if (digest == one.file.digest) return;
                before = version_in_text(text, path.string());
                const std::optional<bool> earlier = is_accepted_before(digest, one);
                if (before == wanted.version && earlier == false && !is_set)
                    refuse(one.file, {QT_TRANSLATE_NOOP(
                                         "errors",
                                         "another curriculum of this version is in force here, which was "
                                         "accepted later; an educator publishes the next version")});
                if (!is_set || before > wanted.version || (before == wanted.version && earlier == true))
                    return;
                keep_superseded(path.string(), before);
            }
            write_output_file(path.string(), one.text,
                              is_set ? OutputFile::Existing::replace : OutputFile::Existing::keep);
            placed_.push_back({one.file, path.string(), std::nullopt});
        } catch (const std::system_error& error) {
            // Another program of the station was faster (an exchange, a window that starts).
            if (is_in_place(one.file)) return;
            refuse(one.file, {QT_TRANSLATE_NOOP("errors", "%1: cannot be written (%2)"), path.string(),
                              error.code().message()});
        } catch (const InputError& problem) {
            refuse(one.file, problem.sentence());
        }
    }

    const AssetPlace& place_;
    AcceptedAssets accepted_;
    std::vector<std::string> tasks_;
    std::vector<PlacedAsset> placed_;
};

}  // namespace

std::string passed_on_name(const std::string& text) {
    nlohmann::json root;
    try {
        root = JsonDocument::parse(text, "").root();
    } catch (const InputError&) {
        return {};
    }
    // By what each of the two has to have, so that one of another version of the program has its name too.
    const auto word = [&](const char* key) {
        return root.is_object() && root.contains(key) && root[key].is_string() ? root[key].get<std::string>()
                                                                               : std::string();
    };
    const auto* device_class = find_row(device_classes, word("device_class"));
    if (device_class != nullptr && root.contains("levels") && !word("task").empty())
        return "benchmarks/" +
               benchmark_name({word("task"), word("variant_family"), device_class->kind, word("fidelity")}) +
               ".json";
    const int version = root.is_object() && root.contains("stages") ? version_in_text(text, "") : 0;
    return version == 0 || word("id").empty()
               ? std::string()
               : "curricula/" + word("id") + "-" + std::to_string(version) + ".json";
}

std::vector<PlacedAsset> place_accepted_assets(const Store& store, const AssetPlace& place) {
    return Placing(store, place).run();
}

}  // namespace fulcrum::database
