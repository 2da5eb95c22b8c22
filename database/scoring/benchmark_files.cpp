// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/benchmark_files.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "database/rows/crypto.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/output_file.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum {

int version_in_text(const std::string& text, const std::string& file) {
    const nlohmann::json set = JsonDocument::parse(text, file).root();
    return set.is_object() && set.contains("version") && set["version"].is_number_integer()
               ? set["version"].get<int>()
               : 0;
}

int version_in_file(const std::string& path) {
    if (!std::filesystem::exists(path)) return 0;
    return version_in_text(read_text_file(path, JsonLimits().bytes), path);
}

void keep_superseded(const std::string& path, int version) {
    if (version == 0) return;
    const std::filesystem::path set = path, folder = set.parent_path() / "superseded";
    std::filesystem::create_directories(folder);
    write_output_file((folder / (set.stem().string() + "@" + std::to_string(version) + ".json")).string(),
                      read_text_file(path, JsonLimits().bytes));
}

std::optional<bool> superseded_is_provisional(const std::string& path, const std::string& sha256) {
    const std::filesystem::path set = path, folder = set.parent_path() / "superseded";
    const std::string start = set.stem().string() + "@";
    std::error_code ignored;
    for (const auto& copy : std::filesystem::directory_iterator(folder, ignored)) {
        if (copy.path().filename().string().rfind(start, 0) != 0) continue;
        try {
            const std::string text = read_text_file(copy.path().string(), JsonLimits().bytes);
            if (database::sha256_hex(text) != sha256) continue;
            const nlohmann::json said = JsonDocument::parse(text, copy.path().string()).root();
            if (said.is_object() && said.contains("provisional") && said["provisional"].is_boolean())
                return said["provisional"].get<bool>();
        } catch (const InputError&) {
            continue;  // not the one that is asked for, or damaged
        }
    }
    return std::nullopt;
}

}  // namespace fulcrum
