// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/hands_page.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <tuple>

#include "sim_core/lab/result_page.h"

namespace fulcrum::app::program_test {
namespace {

constexpr const char* hands_variable = "FULCRUM_HANDS_PAGE";

std::size_t place_of_kind(const std::string& kind) {
    const auto& kinds = hands_kinds();
    return static_cast<std::size_t>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
}

/// What was entered before; a file that cannot be read has nothing.
std::vector<HandsRow> hands_rows_in(const std::string& folder) {
    std::ifstream file(std::filesystem::path(folder) / "hands.json");
    const nlohmann::json document = nlohmann::json::parse(file, nullptr, false);
    std::vector<HandsRow> rows;
    if (!document.is_object() || !document.contains("rows") || !document["rows"].is_array()) return rows;
    for (const nlohmann::json& one : document["rows"])
        rows.push_back({one.value("kind", std::string()), one.value("task", std::string()),
                        one.value("cells", std::vector<std::string>()), one.value("commit", std::string())});
    return rows;
}

void put_hands_row(std::vector<HandsRow>& rows, const HandsRow& row) {
    rows.erase(
        std::remove_if(rows.begin(), rows.end(),
                       [&](const HandsRow& one) { return one.kind == row.kind && one.task == row.task; }),
        rows.end());
    rows.push_back(row);
    const auto place = [](const HandsRow& one) {
        return std::make_tuple(place_of_kind(one.kind), one.task != first_steps_task, one.task);
    };
    std::sort(rows.begin(), rows.end(),
              [&](const HandsRow& a, const HandsRow& b) { return place(a) < place(b); });
}

nlohmann::json hands_document(const std::vector<HandsRow>& rows) {
    nlohmann::json list = nlohmann::json::array();
    for (const HandsRow& row : rows)
        list.push_back(
            {{"kind", row.kind}, {"task", row.task}, {"cells", row.cells}, {"commit", row.commit}});
    nlohmann::json document;
    document["rows"] = std::move(list);
    return document;
}

std::string kinds_not_measured(const std::vector<HandsRow>& rows) {
    std::string names;
    for (const std::string& kind : hands_kinds())
        if (std::none_of(rows.begin(), rows.end(), [&](const HandsRow& row) { return row.kind == kind; }))
            names += (names.empty() ? "" : ", ") + kind;
    return names;
}

}  // namespace

const std::vector<std::string>& hands_kinds() {
    static const std::vector<std::string> kinds = {"Mouse",          "TwoMice", "ControllerOfSdl", "Touch",
                                                   "ForceDimension", "Haply",   "SpaceMouse",      "Tracker",
                                                   "Trainer",        "Joystick"};
    return kinds;
}

const char* hands_folder() {
    return std::getenv(hands_variable);
}

void enter_hands(HandsRow row) {
    const char* const folder = hands_folder();
    if (folder == nullptr) return;
    const lab::Machine machine = lab::this_machine(lab::build_info());
    row.commit = machine.build.commit;
    std::vector<HandsRow> rows = hands_rows_in(folder);
    put_hands_row(rows, row);
    lab::ResultPage page("hands", "First steps and tasks completed with each kind of device",
                         std::string(hands_variable) +
                             "=docs/results xvfb-run -a -s '-screen 0 1280x800x24 -noreset' test_app "
                             "--gtest_filter=HandsAtWork*");
    page.paragraph(
        "The program's window under Xvfb (software rendering) with its own services, threads, world, "
        "recorder and store. A trainee without experience of the device does the first steps of the theatre, "
        "in C4, until each line is marked, and then the tasks. In these a synthetic expert decides where the "
        "instruments go. Events of one mouse and the keyboard, raw events of two pointers of the X server "
        "(XInput 2), sticks, triggers and buttons of a virtual controller of SDL 2, or places, deflections, "
        "jaws and buttons of the fakes of what `fulcrum-hapticd` reads bring them there; what a device does "
        "not have is done with the keys and the mouse that its lines name. A fake hand follows exactly: it "
        "is not pushed by the force that a device renders. Each attempt is made in practice mode, and each "
        "record is replayed bit for bit. Held are keys (with Shift) and mouse buttons by the events that the "
        "window gets; of two mice and of the controller their buttons, and triggers from a tenth on; of the "
        "others closed jaws and buttons. In the first steps only those of mouse and keyboard are counted.");
    const std::string missing = kinds_not_measured(rows);
    if (!missing.empty()) page.paragraph("Not measured: " + missing + ".");
    lab::ResultTable table;
    table.columns = {"device",
                     "task",
                     "how it ended",
                     "time",
                     "points of 100",
                     "input events",
                     "most held at the same time",
                     "time with more than two held",
                     "commit"};
    for (const HandsRow& one : rows) {
        table.rows.push_back(one.cells);
        table.rows.back().push_back(one.commit);
    }
    page.table(table);
    page.document(hands_document(rows));
    page.write(folder, machine);
}

}  // namespace fulcrum::app::program_test
