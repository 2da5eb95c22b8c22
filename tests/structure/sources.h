// SPDX-License-Identifier: Apache-2.0
// The repository's files, for tests that check its structure.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/support.h"

namespace fulcrum::structure {

namespace fs = std::filesystem;

inline const std::vector<std::string> floors = {"sim_core", "assessment", "database", "ui",
                                                "app"};  // lowest first

/// Absolute path of a file or folder of the repository.
inline fs::path source_path(const std::string& relative) {
    return test::source_path(relative);
}

inline std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// Files with one of these extensions below a folder of the repository, sorted; none if it does not exist.
inline std::vector<fs::path> files_below(const std::string& folder,
                                         const std::vector<std::string>& extensions) {
    std::vector<fs::path> found;
    const fs::path root = source_path(folder);
    if (!fs::exists(root)) return found;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        const std::string extension = entry.path().extension().string();
        if (entry.is_regular_file() &&
            std::find(extensions.begin(), extensions.end(), extension) != extensions.end())
            found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// What a source includes, as written between quotes or brackets.
inline std::vector<std::string> includes_of(const std::string& text) {
    static const std::regex pattern(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
    std::vector<std::string> found;
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line)) {
        std::smatch match;
        if (line.find("include") != std::string::npos && std::regex_search(line, match, pattern))
            found.push_back(match[1].str());
    }
    return found;
}

}  // namespace fulcrum::structure
