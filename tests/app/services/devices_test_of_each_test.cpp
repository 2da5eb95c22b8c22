// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum devices --test with each kind of device that fulcrum-hapticd reads: what the page shows without a
// window.
#include <gtest/gtest.h>

#include <QProcess>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "sim_core/instrument/device_class.h"
#include "tests/app/held_devices.h"
#include "tests/app/program_path.h"
#include "tests/support/fake_trainer.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app::program_test {
namespace {

class DevicesTestOf : public ::testing::TestWithParam<std::string> {
  protected:
    /// The exit status; standard output and error are kept.
    int run(const QStringList& arguments) {
        QProcess process;
        process.start(QString::fromUtf8(program_path()), arguments);
        process.closeWriteChannel();
        EXPECT_TRUE(process.waitForFinished(60000));
        output = process.readAllStandardOutput();
        error = process.readAllStandardError();
        return process.exitCode();
    }
    /// What a device that is read by the daemon has in every test of it.
    void expect_read(const nlohmann::json& document, const HeldDevice& device) {
        const nlohmann::json& facts = document.at("device");
        EXPECT_EQ(facts.at("kind"), named.section(QLatin1Char(':'), 0, 0).toStdString());
        EXPECT_NE(facts.at("title").get<std::string>().find(device.model), std::string::npos)
            << facts.at("title");
        EXPECT_EQ(document.at("device_class"), std::string(row_of(device_classes, device.device_class).name));
        EXPECT_EQ(document.at("needs_calibration"), false);
        EXPECT_GT(document.at("rate_hz").get<double>(), 50);
        EXPECT_GT(document.at("ticks").get<double>(), 50);
        for (int hand = 0; hand < hand_count; ++hand) {
            const char* const name = device_slot_names[hand];
            ASSERT_EQ(document.at("poses").contains(name), device.moves[hand]) << name;
            if (!device.moves[hand]) continue;
            EXPECT_EQ(document.at("poses").at(name).at("present"), true) << name;
            EXPECT_TRUE(document.at("frame_check").contains(name)) << name;
        }
    }
    fulcrum::test::OwnFolder folder;
    const fulcrum::test::Variable settings{"XDG_CONFIG_HOME", folder.path().string()};
    QString named;
    QByteArray output, error;
};

TEST_P(DevicesTestOf, ReadsItAndPushesWhereItHasMotorsAndRefusesForceWhereItHasNone) {
    if (GetParam() == "Trainer" && !fulcrum::test::FakeTrainer::is_possible())
        GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    const std::unique_ptr<HeldDevice> device = make_held(GetParam());
    for (int hand = 0; hand < hand_count; ++hand)
        if (device->moves[hand] && !device->is_pushed) device->put(hand, device->begin());
    named = QString::fromLocal8Bit(std::getenv("FULCRUM_DEVICE"));
    QStringList words{"devices", "--test", named, "--seconds", "2", "--json"};
    if (device->feels()) words << "--force";
    ASSERT_EQ(run(words), 0) << error.toStdString();
    const auto document = nlohmann::json::parse(output.toStdString());
    ASSERT_NO_FATAL_FAILURE(expect_read(document, *device));
    const auto rendered = document.at("force_rendered_n").get<double>();
    if (device->feels()) {
        EXPECT_GT(rendered, 0.05);
        EXPECT_LE(rendered, 0.31) << "gentle";
        EXPECT_TRUE(fulcrum::test::until([&] { return device->force() == 0; })) << "after the test";
        return;
    }
    EXPECT_EQ(document.at("force_sent_n"), 0.0);
    EXPECT_EQ(rendered, 0);
    EXPECT_EQ(run({"devices", "--test", named, "--force"}), 2);
    EXPECT_TRUE(error.contains("this device renders no force")) << error.toStdString();
}

std::vector<std::string> tested_kinds() {
    std::vector<std::string> names;
    for (const HeldKind& kind : held_kinds()) names.emplace_back(kind.name);
    return names;
}
INSTANTIATE_TEST_SUITE_P(Kinds, DevicesTestOf, ::testing::ValuesIn(tested_kinds()),
                         [](const auto& of) { return of.param; });

}  // namespace
}  // namespace fulcrum::app::program_test
