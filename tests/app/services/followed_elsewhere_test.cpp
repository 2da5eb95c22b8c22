// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody follows a version of the curriculum that is not at this station: everybody else works, and the
// window names it; an exchange in the window brings it into force; an edited version is shown, not thrown.
#include <QPushButton>
#include <QRadioButton>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "assessment/curriculum/curriculum.h"
#include "database/records/curricula.h"
#include "database/rows/crypto.h"
#include "database/store/accepted_assets.h"
#include "database/sync/enrolment.h"
#include "database/sync/server_enrolment.h"
#include "tests/app/services/window_access.h"
#include "tests/database/postgresql_server.h"
#include "tests/database/station_keys.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app::program_test {
namespace {

/// A copy of the assets, in use while it exists.
class CopiedAssets {
  public:
    CopiedAssets() {
        std::filesystem::copy(assets_folder(), folder_.path(), std::filesystem::copy_options::recursive);
        qputenv("FULCRUM_ASSETS", QByteArray::fromStdString(folder_.path().string()));
    }
    ~CopiedAssets() { before_.isNull() ? qunsetenv("FULCRUM_ASSETS") : qputenv("FULCRUM_ASSETS", before_); }
    std::filesystem::path operator/(const char* name) const { return folder_ / name; }

  private:
    QByteArray before_ = qgetenv("FULCRUM_ASSETS");
    fulcrum::test::OwnFolder folder_;
};

/// The newest version as version 1001.
std::string text_of_1001() {
    nlohmann::json next = nlohmann::json::parse(std::ifstream(asset_path("curricula/rectal.json")));
    next["version"] = 1001;
    return next.dump(2);
}

void move_to_1001(const Store& store, const Session& educator, const std::string& person) {
    const Curriculum installed = load_versions(asset_path("curricula"), "rectal", task_ids());
    Curriculum next = installed;
    next.version = 1001;
    Curriculum before = installed;
    before.older.clear();
    next.older.insert(next.older.begin(), before);
    Curricula(store).move(educator, {person}, next, "rectal@1001", "new rules");
}

class FollowedElsewhere : public WindowAccess {
  protected:
    void move_ann() const {
        const Store store = Store::open(programme.path);
        move_to_1001(store, *programme.educator, programme.id("ann"));
    }
    const CopiedAssets assets;
};

TEST_F(FollowedElsewhere, TheWindowStartsAndNamesIt) {
    move_ann();
    window->start();
    settle();
    ASSERT_EQ(window->current_page()->objectName(), "sign_in_page");
    act_as(programme.asker(Role::trainee));
    ASSERT_TRUE(wait_for([&] { return sees(*window, "curriculum_not_here"); }));
    EXPECT_TRUE(find<QLabel>(*window, "curriculum_not_here")->text().contains("rectal@1001"));
    AttemptRequest request{programme.session("ann"), "A2",  true,    0, nullptr, DeviceClass::mouse_keyboard,
                           "mouse and keyboard",     false, nullptr, 0, false,   ""};
    EXPECT_THROW(services->start_attempt(request), StoreError);
    act_as(programme.asker(Role::administrator));
    click(*window, "rail_station");
    const QString words = find<QLabel>(*window, "curricula_not_here")->text();
    EXPECT_TRUE(sees(*window, "curricula_not_here"));
    EXPECT_TRUE(words.contains("rectal@1001") && words.contains("how many: 1")) << words.toStdString();
}

TEST_F(FollowedElsewhere, NeitherBriefingNorProgressGoesByAnotherVersion) {
    move_ann();
    window->start();
    settle();
    act_as(programme.asker(Role::trainee));
    wait_until_read(*window);
    emit window->context().briefing_wanted(QStringLiteral("A2"));
    EXPECT_FALSE(find<QRadioButton>(*window, "mode_assessed")->isEnabled());
    const QString note = find<QLabel>(*window, "mode_note")->text();
    EXPECT_TRUE(note.contains("rectal@1001")) << note.toStdString();
    click(*window, "briefing_progress");
    wait_until_read(*window);
    EXPECT_EQ(window->current_page()->objectName(), "progress_page");
    EXPECT_FALSE(sees(*window, "standing_text"));
}

TEST_F(FollowedElsewhere, AFileThatWasPutThereSinceIsInForceWhenTheStoreIsOpenedAgain) {
    std::ofstream(assets / "curricula/rectal-1001.json") << text_of_1001();
    move_ann();
    EXPECT_NO_THROW(services->open_store(false));
    ASSERT_NE(services->store(), nullptr);
    EXPECT_EQ(services->curriculum().name(), "rectal@1001");
}

TEST_F(FollowedElsewhere, AnEditedVersionIsShownAtTheStart) {
    AttemptMeta meta = example_meta(programme.id("ann"));
    meta.mode = AttemptMode::practice;  // an assessed one is refused with a file that nobody accepted
    meta.curriculum = "rectal@1";
    meta.assets.push_back({"curricula/rectal-1.json", sha256_hex("as it was")});
    Recorder recorder(programme.path, programme.session("ann"), meta, programme.clock.options());
    Programme::append_second(recorder);
    recorder.finish(example_result(true, 60));
    EXPECT_NO_THROW(window->start());
    settle();
    EXPECT_EQ(window->current_page()->objectName(), "repair_page");
    EXPECT_TRUE(find<QLabel>(*window, "store_problem")->text().contains("different content"));
}

TEST(ExchangeInTheWindow, BringsTheVersionThatSomebodyFollowsIntoForce) {
    FULCRUM_NEEDS_POSTGRESQL();
    const database::test::KeysOfOneTest keys;
    const CopiedAssets assets;
    const AccessProgramme programme;
    const ServerAddress server = database::test::PostgresqlServer::of_this_process()->new_database();
    const Session& administrator = programme.session("administrator");
    enrol_station(*programme.store, administrator, server, make_enrolment_token(server, "", {}, 1).text);
    const auto services = make_services(programme.folder.path().toStdString());
    MainWindow window(*services);
    window.resize(1280, 800);
    window.show();
    window.start();
    // As an exchange leaves it: accepted, with its contents, and not yet in the folder.
    const std::string text = text_of_1001();
    AcceptedAssets(*programme.store)
        .accept(*programme.educator, {"curricula/rectal-1001.json", sha256_hex(text)}, "ours", text);
    move_to_1001(*programme.store, *programme.educator, programme.id("ann"));
    window.context().set_session(administrator);
    click(window, "rail_station");
    EXPECT_TRUE(sees(window, "curricula_not_here"));
    click(window, "exchange_now");
    ASSERT_TRUE(wait_for([&] {
        return sees(window, "server_result") &&
               find<QLabel>(window, "server_result")->text().contains("agree");
    }));
    EXPECT_EQ(services->curriculum().name(), "rectal@1001");
    EXPECT_TRUE(std::filesystem::exists(assets / "curricula/rectal-1001.json"));
    EXPECT_FALSE(sees(window, "curricula_not_here"));
    window.context().sign_out();
}

}  // namespace
}  // namespace fulcrum::app::program_test
