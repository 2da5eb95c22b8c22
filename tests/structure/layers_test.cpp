// SPDX-License-Identifier: Apache-2.0
// The house's rules, checked on the sources: imports run downward only, every file says its licence, no file
// of a machine's path.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/support.h"

namespace fulcrum {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> floors = {"sim_core", "assessment", "database", "ui", "app"};  // lowest first

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<fs::path> files_below(const std::string& folder, const std::vector<std::string>& extensions) {
    std::vector<fs::path> found;
    const fs::path root = test::source_path(folder);
    if (!fs::exists(root)) return found;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        if (!entry.is_regular_file()) continue;
        const std::string extension = entry.path().extension().string();
        if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end())
            found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// What a source of the given floor must not include; empty when the include is allowed.
std::string forbidden(int floor, const std::string& include) {
    for (int above = floor + 1; above < static_cast<int>(floors.size()); ++above) {
        if (include.rfind(floors[static_cast<std::size_t>(above)] + "/", 0) == 0) return "upward";
    }
    const bool qt =
        include.rfind("Qt", 0) == 0 || (include.size() > 1 && include[0] == 'Q' &&
                                        std::isupper(static_cast<unsigned char>(include[1])) != 0);
    if (qt && floor <= 1) return "Qt below database";
    if (qt && floor == 2) {
        static const std::vector<std::string> widgets = {"QtWidgets",    "QtGui",   "QWidget",  "QMessageBox",
                                                         "QApplication", "QDialog", "QPainter", "QtCharts"};
        if (std::find(widgets.begin(), widgets.end(), include) != widgets.end()) return "widgets in database";
    }
    return {};
}

TEST(Layers, IncludesRunDownwardOnly) {
    static const std::regex pattern(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
    std::size_t checked = 0;
    for (int floor = 0; floor < static_cast<int>(floors.size()); ++floor) {
        for (const auto& path : files_below(floors[static_cast<std::size_t>(floor)], {".h", ".cpp"})) {
            std::istringstream lines(read(path));
            std::string line;
            while (std::getline(lines, line)) {
                std::smatch match;
                if (!std::regex_search(line, match, pattern)) continue;
                ++checked;
                EXPECT_EQ(forbidden(floor, match[1].str()), "") << path << " includes " << match[1].str();
            }
        }
    }
    EXPECT_GT(checked, 50U);
}

TEST(Layers, TheRuleItselfFindsForbiddenEdges) {
    EXPECT_EQ(forbidden(0, "assessment/task/task.h"), "upward");
    EXPECT_EQ(forbidden(0, "QString"), "Qt below database");
    EXPECT_EQ(forbidden(1, "QtCore"), "Qt below database");
    EXPECT_EQ(forbidden(2, "QMessageBox"), "widgets in database");
    EXPECT_EQ(forbidden(3, "sim_core/world/world.h"), "");
}

TEST(Layers, EveryFileStatesItsLicence) {
    const std::map<std::string, std::string> licence = {{"sim_core", "Apache-2.0"},
                                                        {"assessment", "Apache-2.0"},
                                                        {"database", "GPL-3.0-or-later"},
                                                        {"ui", "GPL-3.0-or-later"},
                                                        {"app", "GPL-3.0-or-later"}};
    for (const auto& [folder, expected] : licence) {
        for (const auto& path :
             files_below(folder, {".h", ".cpp", ".sql", ".qrc", ".txt", ".vert", ".frag"})) {
            const std::string head = read(path).substr(0, 400);
            EXPECT_NE(head.find("SPDX-License-Identifier: " + expected), std::string::npos) << path;
        }
    }
    for (const std::string folder : {"tests", "docs", "cmake", "assets"}) {
        for (const auto& path :
             files_below(folder, {".h", ".cpp", ".cmake", ".txt", ".md", ".json", ".vert", ".frag"})) {
            if (path.string().find("/corpus/") != std::string::npos) continue;
            EXPECT_NE(read(path).substr(0, 600).find("SPDX-License-Identifier: "), std::string::npos) << path;
        }
    }
}

TEST(Layers, FilesStayReadable) {
    for (const auto& folder : floors) {
        for (const auto& path : files_below(folder, {".h", ".cpp"})) {
            const std::string text = read(path);
            EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 520) << path;
        }
    }
}

}  // namespace
}  // namespace fulcrum
