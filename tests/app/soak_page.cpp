// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/soak_page.h"

#include <algorithm>
#include <cstdlib>

namespace fulcrum::app::program_test {
namespace {

using SoakRow = std::vector<std::string>;

/// The row of a run with this name; null: it has none.
const SoakRow* soak_row(const SoakRun& run, const std::string& what) {
    const auto found =
        std::find_if(run.rows.begin(), run.rows.end(), [&](const SoakRow& row) { return row[0] == what; });
    return found != run.rows.end() ? &*found : nullptr;
}

/// 0 where a run has no such row.
long soak_count(const SoakRow* row) {
    return row != nullptr ? std::strtol((*row)[1].c_str(), nullptr, 10) : 0;
}

std::string column_of(const SoakRun& run) {
    return std::string(run.through_daemon ? "through the device process" : "in process") +
           (run.loaded ? ", all cores busy" : ", alone");
}

lab::ResultPage soak_page(const char* id, const std::string& title, const std::vector<SoakRun>& runs,
                          int seconds) {
    const std::string each = std::to_string(seconds);
    lab::ResultPage page(
        id, title,
        "FULCRUM_SOAK_S=" + each +
            " FULCRUM_SOAK_PAGE=docs/results xvfb-run -a -s '-screen 0 1280x800x24' test_app "
            "--gtest_filter=Soak*");
    page.paragraph(
        "B1 in the real window under Xvfb, with drawing, " + each +
        " s in each run, one run after the other in one process. Both hands grasp and drag the "
        "bowel: *in process* by mouse and key events, *through the device process* by two haptic "
        "devices, fakes of the maker's library that fulcrum-hapticd opens and that the test moves; "
        "the forces go to their motors. *All cores busy*: `fulcrum lab operators C4` at ordinary "
        "priority, again and again. The command makes four runs: " +
        std::to_string(4 * seconds) + " s in all.");
    page.table(soak_table(id, runs));
    bool none = true;
    long by_host = 0;
    for (const SoakRun& run : runs) {
        const SoakRow* const missed = soak_row(run, soak_missed);
        const long then = soak_count(soak_row(run, soak_missed_then));
        none = none && missed != nullptr && soak_count(missed) == then;
        by_host += then;
    }
    page.paragraph(none ? "No tick began a period late by the program's own doing in any of these runs."
                        : "Some ticks began a period late by the program's own doing.");
    if (by_host > 0)
        page.paragraph(
            "A virtual machine counts a part of the time that its host takes from it as the "
            "thread's own. Ticks within 0.05 s of steal time that is as long as they were late "
            "are the host's.");
    return page;
}

}  // namespace

lab::ResultTable soak_table(const std::string& name, const std::vector<SoakRun>& runs) {
    lab::ResultTable table;
    table.name = name;
    table.columns = {"what"};
    for (const SoakRun& run : runs) table.columns.push_back(column_of(run));
    // In the order of the run that has most; the others have no more.
    const auto longest = std::max_element(runs.begin(), runs.end(), [](const SoakRun& a, const SoakRun& b) {
        return a.rows.size() < b.rows.size();
    });
    if (longest == runs.end()) return table;
    for (const SoakRow& row : longest->rows) {
        SoakRow line{row[0]};
        for (const SoakRun& run : runs) {
            const SoakRow* const own = soak_row(run, row[0]);
            line.push_back(own != nullptr ? (*own)[1] : "–");
        }
        table.rows.push_back(std::move(line));
    }
    return table;
}

std::vector<lab::ResultPage> soak_pages(const std::vector<SoakRun>& runs, int seconds) {
    const std::string title = "In real time for " + std::to_string(seconds) + " s";
    std::vector<SoakRun> in_process;
    for (const SoakRun& run : runs)
        if (!run.through_daemon) in_process.push_back(run);
    std::vector<lab::ResultPage> pages;
    if (!in_process.empty()) pages.push_back(soak_page("soak", title, in_process, seconds));
    if (in_process.size() < runs.size())
        pages.push_back(soak_page("soak_daemon", title + ", through the device process", runs, seconds));
    return pages;
}

}  // namespace fulcrum::app::program_test
