// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/hands_page.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "sim_core/numerics/files.h"
#include "tests/fakes/fake_page.h"

namespace fulcrum::app::program_test {
namespace {

class HandsPage : public ::testing::Test {
  protected:
    std::string path(const char* name) const { return folder_.filePath(QLatin1String(name)).toStdString(); }
    std::string text_of(const char* name) const {
        std::ifstream file(path(name));
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }
    std::string page() const { return text_of("hands.md"); }
    static void enter(const char* kind, const char* task, const char* words) {
        enter_hands({kind, task, {words, task, "completed", "1:00.0", "", "9", "1", "0 %"}});
    }

  private:
    QTemporaryDir folder_;
    fulcrum::test::Variable variable_{"FULCRUM_HANDS_PAGE", folder_.path().toStdString()};
};

TEST_F(HandsPage, IsMadeInPartsAndARowThatIsMeasuredAgainIsReplaced) {
    enter("Touch", "C4", "a stylus");
    enter("Touch", "B1", "a stylus");
    enter("Mouse", "B1", "a mouse");
    enter("Touch", first_steps_task, "a stylus");
    enter("Touch", "C4", "another stylus");
    const std::string text = page();
    const std::size_t mouse = text.find("| a mouse | B1"), taught = text.find("| a stylus | first steps"),
                      first = text.find("| a stylus | B1"), second = text.find("| another stylus | C4");
    EXPECT_LT(mouse, taught);
    EXPECT_LT(taught, first);
    EXPECT_LT(first, second);
    EXPECT_LT(second, text.size());
    EXPECT_EQ(text.find("| a stylus | C4"), std::string::npos);
    EXPECT_NE(text.find("Not measured: TwoMice, ControllerOfSdl, ForceDimension, Haply"), std::string::npos)
        << text;
}

TEST_F(HandsPage, KeepsTheRowsOfAnotherCommitWithItsName) {
    enter("Mouse", "B1", "a mouse");
    enter("Mouse", "C4", "a mouse");
    nlohmann::json document = nlohmann::json::parse(text_of("hands.json"));
    ASSERT_EQ(document["rows"].size(), 2U);
    document["rows"][0]["commit"] = "of another day";
    write_whole_file(path("hands.json"), document.dump());
    enter("Touch", "B1", "a stylus");
    EXPECT_NE(page().find("| a mouse | B1 | completed | 1:00.0 |  | 9 | 1 | 0 % | of another day |"),
              std::string::npos)
        << page();
    EXPECT_NE(page().find("| a mouse | C4"), std::string::npos);
    EXPECT_NE(page().find("| a stylus | B1"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::app::program_test
