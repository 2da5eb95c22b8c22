// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/soak_page.h"

#include <gtest/gtest.h>

namespace fulcrum::app::program_test {
namespace {

SoakRun run_of(bool through_daemon, bool loaded, const char* missed) {
    SoakRun run{through_daemon, loaded, {{"ticks", "600000"}, {"missed by the program", missed}}};
    if (through_daemon) run.rows.push_back({"ticks of the device process", "600001"});
    run.rows.push_back({"pictures", loaded ? "9000" : "15000"});
    return run;
}

TEST(SoakPage, HasAColumnForEachRunAndADashWhereARunHasNoValue) {
    const lab::ResultTable table =
        soak_table("soak", {run_of(false, false, "0"), run_of(true, false, "0"), run_of(true, true, "2")});
    EXPECT_EQ(table.columns,
              (std::vector<std::string>{"what", "in process, alone", "through the device process, alone",
                                        "through the device process, all cores busy"}));
    ASSERT_EQ(table.rows.size(), 4U);
    EXPECT_EQ(table.rows[2],
              (std::vector<std::string>{"ticks of the device process", "–", "600001", "600001"}));
    EXPECT_EQ(table.rows[3], (std::vector<std::string>{"pictures", "15000", "15000", "9000"}));
}

TEST(SoakPage, PutsRunsInProcessOnBothPagesAndSaysWhatWasMissed) {
    const std::vector<SoakRun> clean = {run_of(false, false, "0"), run_of(false, true, "0"),
                                        run_of(true, false, "0")};
    auto pages = soak_pages(clean, 600);
    ASSERT_EQ(pages.size(), 2U);
    EXPECT_EQ(pages[0].id(), "soak");
    EXPECT_EQ(pages[1].id(), "soak_daemon");
    const lab::Machine machine{};
    EXPECT_EQ(pages[0].text(machine).find("through the device process, alone"), std::string::npos);
    EXPECT_NE(pages[1].text(machine).find("in process, alone"), std::string::npos);
    EXPECT_NE(pages[1].text(machine).find("2400 s in all"), std::string::npos);
    EXPECT_NE(pages[1].text(machine).find("No tick began a period late"), std::string::npos);
    EXPECT_EQ(pages[1].text(machine).find("are the host's"), std::string::npos);
    pages = soak_pages({run_of(true, true, "2")}, 600);
    ASSERT_EQ(pages.size(), 1U);
    EXPECT_NE(pages[0].text(machine).find("Some ticks began a period late"), std::string::npos);
}

TEST(SoakPage, LeavesTicksToTheHostOnlyWhereAllOfThemAreItsOwn) {
    const lab::Machine machine{};
    SoakRun run = run_of(false, false, "11");
    run.rows.push_back({soak_missed_then, "11"});
    const std::string all = soak_pages({run}, 600)[0].text(machine);
    EXPECT_NE(all.find("No tick began a period late by the program's own doing"), std::string::npos) << all;
    EXPECT_NE(all.find("are the host's"), std::string::npos);
    run.rows.back()[1] = "10";
    EXPECT_NE(soak_pages({run}, 600)[0].text(machine).find("Some ticks began a period late"),
              std::string::npos);
}

}  // namespace
}  // namespace fulcrum::app::program_test
