// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/benchmark_files.h"

#include <filesystem>
#include <nlohmann/json.hpp>

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

}  // namespace fulcrum
