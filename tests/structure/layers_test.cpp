// SPDX-License-Identifier: Apache-2.0
// Rules for the source tree: includes go to lower floors only, every file states its licence, files stay
// short, and no file contains a path of a particular machine.
#include <gtest/gtest.h>

#include <cctype>
#include <map>

#include "tests/structure/sources.h"

namespace fulcrum::structure {
namespace {

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

TEST(Layers, IncludesGoToLowerFloorsOnly) {
    std::size_t checked = 0;
    for (int floor = 0; floor < static_cast<int>(floors.size()); ++floor) {
        for (const auto& path : files_below(floors[static_cast<std::size_t>(floor)], {".h", ".cpp"})) {
            for (const std::string& include : includes_of(read(path))) {
                ++checked;
                EXPECT_EQ(forbidden(floor, include), "") << path << " includes " << include;
            }
        }
    }
    EXPECT_GT(checked, 50U);
}

TEST(Layers, TheRuleFindsForbiddenIncludes) {
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
        for (const auto& path : files_below(
                 folder, {".h", ".cpp", ".inc", ".cmake", ".sql", ".qrc", ".txt", ".vert", ".frag"})) {
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

TEST(Layers, FilesHaveAtMostFiveHundredLines) {
    for (const auto& folder : floors) {
        for (const auto& path : files_below(folder, {".h", ".cpp"})) {
            const std::string text = read(path);
            EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 500) << path;
        }
    }
}

/// The first path of a particular machine in the text, or nothing.
std::string machine_path(const std::string& text) {
    static const std::regex pattern(
        R"re((^|[\s"'=(`:])((/home/|/root/|/Users/|/work/|/mnt/|/media/)[\w.-]+|[A-Z]:\\[\w]+))re");
    static const std::vector<std::string> starts = {"/home/", "/root/",  "/Users/", "/work/",
                                                    "/mnt/",  "/media/", ":\\"};
    const auto appears = [&](const std::string& start) { return text.find(start) != std::string::npos; };
    if (std::none_of(starts.begin(), starts.end(), appears)) return {};
    std::smatch match;
    return std::regex_search(text, match, pattern) ? match[2].str() : std::string();
}

TEST(Layers, NoFileContainsAPathOfAMachine) {
    std::size_t checked = 0;
    for (const std::string folder :
         {"sim_core", "assessment", "database", "ui", "app", "tests", "docs", "cmake", "assets", ".ci"}) {
        for (const auto& path : files_below(folder, {".h", ".cpp", ".cmake", ".txt", ".md", ".json", ".sql",
                                                     ".qrc", ".svg", ".csv", ".vert", ".frag", ""})) {
            std::istringstream lines(read(path));
            std::string line;
            for (int number = 1; std::getline(lines, line); ++number) {
                if (path.filename() == "layers_test.cpp") continue;
                EXPECT_EQ(machine_path(line), "") << path << ":" << number;
            }
            ++checked;
        }
    }
    for (const std::string file : {"run", "README.md", "CMakeLists.txt", "CMakePresets.json"})
        EXPECT_EQ(machine_path(read(source_path(file))), "") << file;
    EXPECT_GT(checked, 500U);
    EXPECT_EQ(machine_path("see /home/anna/fulcrum"), "/home/anna");
    EXPECT_EQ(machine_path("\"/root/data\""), "/root/data");
    EXPECT_EQ(machine_path("open C:\\data"), "C:\\data");
    EXPECT_EQ(machine_path("docs/work/page, https://a.org/home/b, /bowel/radius"), "");
}

}  // namespace
}  // namespace fulcrum::structure
