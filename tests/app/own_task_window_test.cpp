// SPDX-License-Identifier: GPL-3.0-or-later
// The program's window with a folder of assets in which somebody made a task easier.
#include <QRadioButton>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "assessment/assets/assets.h"
#include "database/rows/crypto.h"
#include "sim_core/numerics/input_error.h"
#include "tests/app/window_fixture.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app::program_test {
namespace {

using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

/// A copy of the assets whose A2 has four targets for each hand instead of ten.
class FourTargets {
  protected:
    FourTargets() {
        std::filesystem::copy(assets_folder(), folder_.path(), std::filesystem::copy_options::recursive);
        const std::filesystem::path file = folder_ / "tasks/A2.json";
        nlohmann::json task = nlohmann::json::parse(std::ifstream(file));
        for (nlohmann::json& goal : task["goals"]) goal["count"] = 4;
        std::ofstream(file) << task.dump(1);
        std::ostringstream text;
        text << std::ifstream(file).rdbuf();
        digest = database::sha256_hex(text.str());
        qputenv("FULCRUM_ASSETS", QByteArray::fromStdString(folder_.path().string()));
    }
    ~FourTargets() { before_.isNull() ? qunsetenv("FULCRUM_ASSETS") : qputenv("FULCRUM_ASSETS", before_); }
    std::string digest;

  private:
    QByteArray before_ = qgetenv("FULCRUM_ASSETS");
    fulcrum::test::OwnFolder folder_;
};

/// The window finds its assets when it is made: after them.
class OwnTaskWindow : protected FourTargets, public Window {};

TEST_F(OwnTaskWindow, IsPracticeOnlyAndItsDebriefNamesTheFile) {
    create_programme_and_trainee();
    click(window, "briefing_A2");
    expect_page("briefing_page");
    EXPECT_FALSE(find<QRadioButton>(window, "mode_assessed")->isEnabled());
    const QString named = QString::fromStdString("tasks/A2.json (sha256 " + digest + ")");
    const QString why = shown("mode_note");
    EXPECT_TRUE(
        why.contains("Here this task is practice only: it uses files that are neither part of this "
                     "program nor accepted by the programme: " +
                     named + ". An educator can accept them."))
        << why.toStdString();
    // Nor does it begin where the page is passed by.
    const AttemptRequest request{window.context().session(), "A2",  true,    5, nullptr, window_device,
                                 "mouse and keyboard",       false, nullptr, 0, false,   {}};
    try {
        services.start_attempt(request);
        ADD_FAILURE() << "it began";
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("practice only: these files are neither part of this program nor "
                                       "accepted by the programme: tasks/A2.json (sha256 " +
                                       digest + ")"),
                  std::string::npos)
            << error.what();
    }
    EXPECT_TRUE(database::Attempts(*services.store()).list(window.context().session()).empty());
    click(window, "start_attempt");
    expect_page("theatre_page");
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }, 120000));
    abandon();
    EXPECT_EQ(newest_attempt().meta.mode, AttemptMode::practice);
    EXPECT_TRUE(shown("debrief_notes")
                    .contains("Practised with files that are neither part of this program nor accepted by "
                              "the programme: " +
                              named))
        << shown("debrief_notes").toStdString();
}

}  // namespace
}  // namespace fulcrum::app::program_test
