// SPDX-License-Identifier: Apache-2.0
// Rooms: each folder of sources is a library that fulcrum_room() declares together with the rooms it may use.
// CMake links what these declarations say; the tests here compare them with what the sources include.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

#include "tests/structure/sources.h"

namespace fulcrum::structure {
namespace {

struct Room {
    std::set<std::string> with;  // folders below that belong to it
    std::set<std::string> uses;
    std::set<std::string> links;
};
using Rooms = std::map<std::string, Room>;

/// The fulcrum_room() calls in the text of a CMakeLists.txt.
Rooms parse_rooms(const std::string& text) {
    static const std::regex comment(R"(#[^\n]*)"), call(R"(fulcrum_room\(([^)]*)\))");
    static const std::set<std::string> keywords = {"USES", "LINKS", "PCH", "APART", "WITH"};
    const std::string code = std::regex_replace(text, comment, "");
    Rooms rooms;
    for (std::sregex_iterator it(code.begin(), code.end(), call), end; it != end; ++it) {
        std::istringstream words((*it)[1].str());
        std::string name, word, part;
        words >> name;
        Room& room = rooms[name];
        while (words >> word) {
            if (keywords.count(word) != 0)
                part = word;
            else if (part == "USES")
                room.uses.insert(word);
            else if (part == "LINKS")
                room.links.insert(word);
            else if (part == "WITH")
                room.with.insert(name + "/" + word);
        }
    }
    return rooms;
}

Rooms declared_rooms() {
    Rooms rooms;
    for (const std::string& floor : floors)
        rooms.merge(parse_rooms(read(source_path(floor + "/CMakeLists.txt"))));
    for (const fs::path& path : files_below("sim_core/world/parts", {".cmake"}))
        rooms.merge(parse_rooms(read(path)));
    return rooms;
}

/// Rooms of the parts, which the world links and whose builders its registry declares from a list: it
/// includes nothing of them.
std::set<std::string> part_rooms(const Rooms& rooms) {
    std::set<std::string> parts;
    for (const auto& entry : rooms)
        if (entry.first.rfind("sim_core/world/parts/", 0) == 0) parts.insert(entry.first);
    return parts;
}

/// The room of a source, given its path in the repository.
std::string room_of(const Rooms& rooms, const std::string& path) {
    const auto slash = path.rfind('/');
    const std::string folder = slash == std::string::npos ? std::string() : path.substr(0, slash);
    for (const auto& [name, room] : rooms) {
        if (room.with.count(folder) != 0) return name;
    }
    return folder;
}

bool is_ours(const std::string& include) {
    return std::any_of(floors.begin(), floors.end(),
                       [&](const std::string& floor) { return include.rfind(floor + "/", 0) == 0; });
}

/// Rooms that each folder's sources include, with one example each.
std::map<std::string, std::map<std::string, std::string>> included_rooms(const Rooms& declared) {
    std::map<std::string, std::map<std::string, std::string>> found;
    for (const std::string& floor : floors) {
        for (const fs::path& path : files_below(floor, {".h", ".cpp"})) {
            const std::string name = fs::relative(path, source_path("")).generic_string();
            auto& rooms = found[room_of(declared, name)];
            for (const std::string& include : includes_of(read(path))) {
                if (!is_ours(include)) continue;
                const std::string room = room_of(declared, include);
                if (room != room_of(declared, name)) rooms.emplace(room, name + " includes " + include);
            }
        }
    }
    return found;
}

/// A cycle as "a > b > a"; empty if there is none.
std::string find_cycle(const Rooms& rooms) {
    std::map<std::string, int> state;  // 1: on the path, 2: done
    std::vector<std::string> path;
    std::string cycle;
    const std::function<bool(const std::string&)> visit = [&](const std::string& name) {
        if (state[name] == 2) return false;
        path.push_back(name);
        if (state[name] == 1) {
            for (auto it = std::find(path.begin(), path.end(), name); it != path.end(); ++it)
                cycle += (cycle.empty() ? "" : " > ") + *it;
            return true;
        }
        state[name] = 1;
        const auto room = rooms.find(name);
        if (room != rooms.end()) {
            for (const std::string& used : room->second.uses) {
                if (visit(used)) return true;
            }
        }
        path.pop_back();
        state[name] = 2;
        return false;
    };
    for (const auto& entry : rooms) {
        if (visit(entry.first)) return cycle;
    }
    return {};
}

/// All libraries that a room links through the rooms that it uses.
std::set<std::string> linked_libraries(const Rooms& rooms, const std::string& name) {
    std::set<std::string> libraries, seen;
    const std::function<void(const std::string&)> visit = [&](const std::string& room) {
        if (!seen.insert(room).second || rooms.count(room) == 0) return;
        libraries.insert(rooms.at(room).links.begin(), rooms.at(room).links.end());
        for (const std::string& used : rooms.at(room).uses) visit(used);
    };
    visit(name);
    return libraries;
}

TEST(Rooms, EveryFolderWithSourcesIsDeclaredAndEveryDeclaredRoomExists) {
    const Rooms rooms = declared_rooms();
    const auto included = included_rooms(rooms);
    for (const auto& entry : included)
        EXPECT_EQ(rooms.count(entry.first), 1U) << entry.first << " has no fulcrum_room()";
    for (const auto& entry : rooms)
        EXPECT_EQ(included.count(entry.first), 1U) << entry.first << " has no sources";
}

TEST(Rooms, EveryIncludeGoesToARoomThatIsListed) {
    const Rooms rooms = declared_rooms();
    for (const auto& [name, included] : included_rooms(rooms)) {
        if (rooms.count(name) == 0) continue;
        for (const auto& [room, example] : included)
            EXPECT_EQ(rooms.at(name).uses.count(room), 1U)
                << example << ": add " << room << " to USES of " << name;
    }
}

TEST(Rooms, EveryListedRoomIsIncluded) {
    const Rooms rooms = declared_rooms();
    const auto included = included_rooms(rooms);
    for (const auto& [name, room] : rooms) {
        if (included.count(name) == 0) continue;
        for (const std::string& used : room.uses)
            EXPECT_EQ(included.at(name).count(used), 1U)
                << name << " includes nothing of " << used << ": remove it from USES";
    }
}

TEST(Rooms, HaveNoCycle) {
    Rooms rooms = declared_rooms();
    rooms.at("sim_core/world").uses.merge(part_rooms(rooms));
    EXPECT_EQ(find_cycle(rooms), "");
}

// The registry builds the parts of a list without including any, and a coupling names both its ends.
// Everything else meets a part by Part, by its view in the snapshot or by its local model. What measures a
// part by itself is named here. The operative field is no part: bands and structures, which lie in one, have
// a copy of it each.
bool may_include_part(const std::string& file, const std::string& part) {
    static const std::map<std::string, std::set<std::string>> measured = {
        {"sim_core/lab/sheet_workloads.cpp", {"sim_core/world/parts/sheet/"}}};
    static const std::map<std::string, std::vector<std::string>> shared = {
        {"sim_core/world/field/", {"sim_core/world/parts/bands/", "sim_core/world/parts/structures/"}}};
    const auto below = [&](const std::string& folder) { return file.rfind(folder, 0) == 0; };
    if (below(part)) return true;
    const auto users = shared.find(part);
    if (users != shared.end()) return std::any_of(users->second.begin(), users->second.end(), below);
    const auto found = measured.find(file);
    if (found != measured.end() && found->second.count(part) != 0) return true;
    return below("sim_core/world/couplings/");
}

/// "sim_core/world/parts/NAME/" or "sim_core/world/field/", or empty.
std::string part_of(const std::string& include) {
    static const std::string parts = "sim_core/world/parts/", field = "sim_core/world/field/";
    if (include.rfind(field, 0) == 0) return field;
    return include.rfind(parts, 0) == 0 ? include.substr(0, include.find('/', parts.size()) + 1)
                                        : std::string();
}

TEST(Rooms, OnlyCouplingsIncludeAPartOfTheWorld) {
    int parts_included = 0;
    for (const std::string& floor : floors) {
        for (const fs::path& path : files_below(floor, {".h", ".cpp"})) {
            const std::string name = fs::relative(path, source_path("")).generic_string();
            for (const std::string& include : includes_of(read(path))) {
                const std::string part = part_of(include);
                if (part.empty()) continue;
                ++parts_included;
                EXPECT_TRUE(may_include_part(name, part)) << name << " includes " << include;
            }
        }
    }
    EXPECT_GT(parts_included, 10) << "where parts are has moved";
    EXPECT_FALSE(may_include_part("sim_core/world/parts/bands/bands_part.h", "sim_core/world/parts/sheet/"));
    EXPECT_TRUE(may_include_part("sim_core/world/parts/bands/bands_part.h", "sim_core/world/parts/bands/"));
    EXPECT_EQ(part_of("sim_core/world/parts/sheet/sheet_part.h"), "sim_core/world/parts/sheet/");
    EXPECT_TRUE(may_include_part("sim_core/lab/sheet_workloads.cpp", "sim_core/world/parts/sheet/"));
    EXPECT_FALSE(may_include_part("sim_core/lab/sheet_workloads.cpp", "sim_core/world/parts/bowel/"));
    EXPECT_FALSE(may_include_part("sim_core/lab/rod_study.cpp", "sim_core/world/parts/sheet/"));
    EXPECT_EQ(part_of("sim_core/world/field/field_bed.h"), "sim_core/world/field/");
    EXPECT_TRUE(may_include_part("sim_core/world/parts/bands/bands_part.h", "sim_core/world/field/"));
    EXPECT_FALSE(may_include_part("sim_core/world/parts/sheet/sheet_part.h", "sim_core/world/field/"));
    EXPECT_FALSE(may_include_part("sim_core/world/registry.cpp", "sim_core/world/parts/sheet/"));
}

/// Names of the parts' views: their types in the headers of sim_core/world/part, their members in the
/// snapshot, and what a local model has of each.
std::set<std::string> names_of_views() {
    std::set<std::string> names = {"targets"};  // spheres, which the snapshot holds as they are
    static const std::regex type(R"(\bstruct (\w+)\s*\{)"), member(R"((\w+)>?\s+(\w+);)");
    for (const fs::path& path : files_below("sim_core/world/part", {".h"})) {
        const std::string name = path.filename().string();
        if (name.size() < 7 || name.substr(name.size() - 7) != "_view.h") continue;
        const std::string text = read(path);
        for (std::sregex_iterator it(text.begin(), text.end(), type), end; it != end; ++it)
            names.insert((*it)[1].str());
    }
    const std::set<std::string> types = names;
    const std::string snapshot = read(source_path("sim_core/world/part/snapshot.h"));
    for (std::sregex_iterator it(snapshot.begin(), snapshot.end(), member), end; it != end; ++it) {
        if (types.count((*it)[1].str()) != 0) names.insert((*it)[2].str());
    }
    static const std::regex part(R"(\bWORLD_PART\((\w+), (?:std::vector<)?(\w+)>?\))");
    const std::string parts = read(source_path("sim_core/world/part/world_parts.inc"));
    for (std::sregex_iterator it(parts.begin(), parts.end(), part), end; it != end; ++it) {
        if (types.count((*it)[2].str()) != 0) names.insert((*it)[1].str());
    }
    const std::string model = read(source_path("sim_core/contact/local_model.h"));
    for (std::sregex_iterator it(model.begin(), model.end(), member), end; it != end; ++it) {
        const std::string kind = (*it)[1].str();
        if (kind == "SurfacePatch" || (kind.size() > 5 && kind.substr(kind.size() - 5) == "Model"))
            names.insert((*it)[2].str());
    }
    return names;
}

/// The names that a source uses: a type anywhere, a member of something.
std::set<std::string> names_used(const std::string& text, const std::set<std::string>& names) {
    static const std::regex comment(R"(//[^\n]*)"), word(R"((\.|->)?\s*\b([A-Za-z_]\w*)\b(\s*\()?)");
    const std::string code = std::regex_replace(text, comment, "");
    std::set<std::string> used;
    for (std::sregex_iterator it(code.begin(), code.end(), word), end; it != end; ++it) {
        const std::string name = (*it)[2].str();
        const bool is_type = std::isupper(static_cast<unsigned char>(name[0])) != 0;
        const bool is_member = (*it)[1].matched && !(*it)[3].matched;
        if (names.count(name) != 0 && (is_type || is_member)) used.insert(name);
    }
    return used;
}

TEST(Rooms, TheWorldNamesNoPartsView) {
    const std::set<std::string> names = names_of_views();
    for (const std::string known :
         {"BowelView", "BowelCutView", "SheetView", "BandsView", "CameraTarget", "bowel", "sheet", "bands",
          "field", "membranes", "structures", "objects", "camera_targets", "patch", "grasp", "jaws"})
        EXPECT_EQ(names.count(known), 1U) << known;
    int read_files = 0;
    for (const fs::path& path : files_below("sim_core/world", {".h", ".cpp"})) {
        const std::string file = fs::relative(path, source_path("sim_core/world")).generic_string();
        if (file != "world.h" && file != "world.cpp" && file.rfind("world_", 0) != 0) continue;
        ++read_files;
        for (const std::string& name : names_used(read(path), names))
            ADD_FAILURE() << file << " names " << name << ": give the deed to Part";
    }
    EXPECT_GE(read_files, 2);
    EXPECT_EQ(names_used("n = snapshot_.bowel.dents; // a SheetView\nSheetView v; p->field; int field; "
                         "x.fields; x.grasp()",
                         names),
              (std::set<std::string>{"SheetView", "bowel", "field"}));
}

TEST(Rooms, OnlyTheLaboratorysProgramIncludesTheLaboratory) {
    for (const auto& [name, room] : declared_rooms()) {
        if (room.uses.count("sim_core/lab") != 0) {
            EXPECT_EQ(name, "app/lab");
        }
        EXPECT_EQ(room.uses.count("app/lab"), 0U) << name;
    }
}

TEST(Rooms, NothingBelowTheWindowLinksOrIncludesWidgets) {
    const Rooms rooms = declared_rooms();
    // Qt headers that come with Qt Core, Qt SQL and Qt Network; everything else needs a window system.
    const std::set<std::string> plain = {"QBuffer",
                                         "QByteArray",
                                         "QCoreApplication",
                                         "QDataStream",
                                         "QDate",
                                         "QDateTime",
                                         "QDir",
                                         "QEventLoop",
                                         "QFile",
                                         "QFileInfo",
                                         "QHash",
                                         "QHostAddress",
                                         "QIODevice",
                                         "QJsonArray",
                                         "QJsonDocument",
                                         "QJsonObject",
                                         "QLibraryInfo",
                                         "QLocale",
                                         "QLockFile",
                                         "QNetworkAccessManager",
                                         "QNetworkReply",
                                         "QNetworkRequest",
                                         "QProcess",
                                         "QRegularExpression",
                                         "QSaveFile",
                                         "QSqlDatabase",
                                         "QSqlDriver",
                                         "QSqlError",
                                         "QSqlField",
                                         "QSqlQuery",
                                         "QSqlRecord",
                                         "QStandardPaths",
                                         "QString",
                                         "QStringList",
                                         "QSysInfo",
                                         "QTextCodec",
                                         "QTranslator",
                                         "QUrl",
                                         "QUrlQuery",
                                         "QUuid",
                                         "QVariant",
                                         "QXmlStreamReader",
                                         "QtCore",
                                         "QtGlobal",
                                         "QtSql"};
    // The laboratory draws figures of its experiments with the theatre's renderer: OpenGL, which is part of
    // Qt GUI, but no widget. app/services puts window and records together and links all of it.
    const std::set<std::string> draws = {"app/lab", "ui/theatre/renderer"};
    const std::set<std::string> windowless = {"app/live",    "app/cli",     "app/igtl",           "app/lab",
                                              "ui/services", "ui/language", "ui/theatre/renderer"};
    for (const auto& [name, room] : rooms) {
        const bool headless = name.rfind("sim_core", 0) == 0 || name.rfind("assessment", 0) == 0 ||
                              name.rfind("database", 0) == 0 || windowless.count(name) != 0;
        if (!headless) continue;
        const bool gui = draws.count(name) != 0;
        for (const std::string& library : linked_libraries(rooms, name)) {
            if (library.rfind("Qt5::", 0) != 0) continue;
            EXPECT_TRUE(library == "Qt5::Core" || library == "Qt5::Sql" || library == "Qt5::Network" ||
                        (gui && library == "Qt5::Gui"))
                << name << " links " << library;
        }
        for (const fs::path& path : files_below(name, {".h", ".cpp"})) {
            if (gui) continue;  // what links no widgets cannot include them
            for (const std::string& include : includes_of(read(path))) {
                if (include.size() < 2 || include[0] != 'Q' || include.find('/') != std::string::npos)
                    continue;
                EXPECT_EQ(plain.count(include), 1U) << path << " includes " << include;
            }
        }
    }
}

TEST(Rooms, TheChecksFindWhatTheyLookFor) {
    const Rooms rooms = parse_rooms(
        "fulcrum_room(a USES b c LINKS x)  # fulcrum_room(d)\nfulcrum_room(b USES c\n    LINKS y APART "
        "z)\nfulcrum_room(c)");
    EXPECT_EQ(rooms.size(), 3U);
    EXPECT_EQ(rooms.at("a").uses, (std::set<std::string>{"b", "c"}));
    EXPECT_EQ(find_cycle(rooms), "");
    EXPECT_EQ(linked_libraries(rooms, "a"), (std::set<std::string>{"x", "y"}));
    EXPECT_EQ(find_cycle(parse_rooms("fulcrum_room(a USES b) fulcrum_room(b USES c) fulcrum_room(c USES a)")),
              "a > b > c > a");
    EXPECT_EQ(includes_of("  #include \"a/b.h\"\n// #include\n#include <QString>\n"),
              (std::vector<std::string>{"a/b.h", "QString"}));
}

}  // namespace
}  // namespace fulcrum::structure
