// SPDX-License-Identifier: GPL-3.0-or-later
// An assessed attempt begins with devices only that the curriculum counts which its person follows.
#include <gtest/gtest.h>

#include <QByteArray>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/services/application.h"
#include "app/services/program.h"
#include "sim_core/numerics/input_error.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/own_folder.h"
#include "tests/support/support.h"

namespace fulcrum::app {
namespace {

/// With a copy of the assets whose curriculum counts A2 with haptic devices only.
class CountedDevices : public ::testing::Test {
  protected:
    CountedDevices() {
        const std::filesystem::path assets = folder_ / "assets";
        std::filesystem::copy(fulcrum::test::source_path("assets"), assets,
                              std::filesystem::copy_options::recursive);
        const std::filesystem::path file = assets / "curricula/rectal.json";
        nlohmann::json curriculum = nlohmann::json::parse(std::ifstream(file));
        for (nlohmann::json& task : curriculum["tasks"])
            if (task["task"] == "A2") task["device_classes"] = {"haptic"};
        std::ofstream(file) << curriculum.dump(1);
        qputenv("FULCRUM_ASSETS", QByteArray::fromStdString(assets.string()));
    }
    ~CountedDevices() override {
        if (before_.isNull())
            qunsetenv("FULCRUM_ASSETS");
        else
            qputenv("FULCRUM_ASSETS", before_);
    }
    /// Of an assessed attempt at A2 with mouse and keyboard.
    static std::string refusal(const database::test::Programme& programme, const database::Session& session) {
        const auto services = make_services(programme.folder.path().toStdString(), "");
        services->open_store(false);
        ui::AttemptRequest request{
            session, "A2",    true, 5,     nullptr, ui::window_device, "mouse and keyboard",
            false,   nullptr, 0,    false, {}};
        try {
            services->start_attempt(request);
        } catch (const InputError& error) {
            return error.problem();
        }
        return "none";
    }
    fulcrum::test::OwnFolder folder_;
    QByteArray before_ = qgetenv("FULCRUM_ASSETS");
};

TEST_F(CountedDevices, AnAssessedAttemptWithAnotherOneIsRefused) {
    const database::test::Programme programme;
    EXPECT_EQ(refusal(programme, programme.session("ann")),
              "the curriculum rectal@3 does not count attempts with mouse and keyboard, they are practice "
              "only");
}

TEST_F(CountedDevices, AnyoneWhoMayBuildLimitsIsNotAskedBecauseASetIsBuiltOfSuchAttempts) {
    const database::test::Programme programme;
    programme.people().set_roles(programme.session("administrator"), programme.id("ann"),
                                 {database::Role::trainee, database::Role::educator});
    const database::Session ann =
        programme.people().act_as(programme.session("ann"), database::Role::trainee);
    // The edited curriculum is not accepted here: that is the only reason left.
    const std::string words = refusal(programme, ann);
    EXPECT_EQ(words.find("does not count"), std::string::npos) << words;
    EXPECT_NE(words.find("curricula/rectal.json"), std::string::npos) << words;
}

TEST_F(CountedDevices, TheCommandAsksTheSame) {
    const database::test::Programme programme;
    try {
        run_command(
            {"perform", "A2", "--seed", "5", "--device-class", "mouse-keyboard", "--db", programme.path});
        ADD_FAILURE() << "it was performed";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.problem()),
                  "the curriculum rectal@3 does not count attempts with mouse and keyboard, they are "
                  "practice only");
    }
    EXPECT_TRUE(programme.attempts().list(programme.session("station"), {}).empty());
}

}  // namespace
}  // namespace fulcrum::app
