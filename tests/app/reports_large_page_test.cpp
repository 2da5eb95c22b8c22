// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/reports_large_page.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "sim_core/numerics/files.h"
#include "tests/fakes/fake_page.h"

namespace fulcrum::app::program_test {
namespace {

class ReportsLargePage : public ::testing::Test {
  protected:
    std::string path(const char* name) const { return folder_.filePath(QLatin1String(name)).toStdString(); }
    std::string text_of(const char* name) const {
        std::ifstream file(path(name));
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }
    std::string page() const { return text_of("reports_large.md"); }
    static ReportsRow row(const char* what, int metrics, std::optional<double> station,
                          std::optional<double> server, std::optional<double> limit) {
        ReportsRow made;
        made.what = what;
        made.trainees = 200;
        made.attempts = 300;
        made.metrics = metrics;
        made.station_s = station;
        made.server_s = server;
        made.limit_s = limit;
        return made;
    }

  private:
    QTemporaryDir folder_;
    fulcrum::test::Variable variable_{"FULCRUM_REPORTS_PAGE", folder_.path().toStdString()};
};

TEST_F(ReportsLargePage, HasTheTimesOfBothStoresTheLimitAndTheSize) {
    enter_reports({row("PDF", 3, 2.714, 3.7, 5.0), row("grid of an educator", 3, {}, 0.738, 1.0)});
    EXPECT_NE(page().find("| PDF | 2.71 s | 3.70 s | 5 s | 200 | 300 | 3 |"), std::string::npos) << page();
    EXPECT_NE(page().find("| grid of an educator | – | 0.74 s | 1 s | 200 | 300 | 3 |"), std::string::npos);
    EXPECT_NE(page().find("Every time that has a limit is within it."), std::string::npos);
    EXPECT_NE(text_of("reports_large.csv").find("PDF,2.71 s,3.70 s,5 s,200,300,3"), std::string::npos);
}

TEST_F(ReportsLargePage, IsMadeInPartsAndSaysWhatIsOverItsLimit) {
    enter_reports({row("statements", 166, 40.0, 50.0, {})});
    EXPECT_EQ(page().find("limit is within"), std::string::npos) << "nothing has a limit";
    enter_reports({row("PDF", 3, 2.0, 5.5, 5.0), row("statements", 3, 2.0, 2.5, 5.0)});
    enter_reports({row("statements", 166, 41.0, 51.0, {})});
    const std::string text = page();
    const std::size_t pdf = text.find("| PDF | 2.00 s | 5.50 s |"),
                      few = text.find("| statements | 2.00 s | 2.50 s | 5 s |"),
                      many = text.find("| statements | 41.00 s | 51.00 s | – | 200 | 300 | 166 |");
    EXPECT_LT(pdf, few);
    EXPECT_LT(few, many);
    EXPECT_LT(many, text.size());
    EXPECT_EQ(text.find("40.00 s"), std::string::npos);
    EXPECT_NE(text.find("Over the limit: PDF."), std::string::npos);
}

TEST_F(ReportsLargePage, LeavesOutTheRowsOfAnotherCommit) {
    enter_reports({row("PDF", 3, 2.0, 3.0, 5.0), row("CSV", 3, 1.0, 1.5, 5.0)});
    nlohmann::json document = nlohmann::json::parse(text_of("reports_large.json"));
    ASSERT_EQ(document["rows"].size(), 2U);
    document["rows"][0]["commit"] = "of another day";
    write_whole_file(path("reports_large.json"), document.dump());
    enter_reports({row("JSON", 3, 1.0, 1.5, 5.0)});
    EXPECT_EQ(page().find("| PDF |"), std::string::npos);
    EXPECT_NE(page().find("| CSV |"), std::string::npos);
    EXPECT_NE(page().find("| JSON |"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::app::program_test
