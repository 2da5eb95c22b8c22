// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/application.h"

#include <QApplication>
#include <filesystem>
#include <list>
#include <map>
#include <random>

#include "app/cli/command_line.h"
#include "app/cli/installed_curriculum.h"
#include "app/cli/placed_assets.h"
#include "app/live/frame_follower.h"
#include "app/live/frame_keeping.h"
#include "app/live/frames_in_advance.h"
#include "app/live/interrupted.h"
#include "app/live/live_attempt.h"
#include "app/live/replay_moment.h"
#include "app/live/simulation_check.h"
#include "app/live/stored_start.h"
#include "app/services/demo.h"
#include "app/services/device_list.h"
#include "app/services/devices.h"
#include "app/services/expert_attempt.h"
#include "app/services/ghosts.h"
#include "app/services/replay_source.h"
#include "app/services/sending.h"
#include "app/services/sounds.h"
#include "assessment/assets/assets.h"
#include "assessment/attempt/engine.h"
#include "assessment/metrics/version.h"
#include "assessment/operators/operator.h"
#include "database/records/assessed_attempts.h"
#include "database/records/curricula.h"
#include "database/records/curriculum_publishing.h"
#include "database/rows/crypto.h"
#include "database/scoring/rescoring.h"
#include "database/scoring/site_tissues.h"
#include "database/store/accepted_assets.h"
#include "database/store/kept_frames.h"
#include "database/store/quick_check.h"
#include "database/sync/station_erasure.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "ui/shell/main_window.h"
#include "ui/shell/window_application.h"
#include "ui/style/appearance.h"

namespace fulcrum::app {
namespace {

std::string device_from_environment() {
    const char* const named = std::getenv("FULCRUM_DEVICE");
    return named != nullptr ? named : "";
}

/// Owns the store, the tasks and the attempts' threads; devices are handled by the rig.
class Services : public ui::ApplicationServices {
  public:
    Services(std::string folder, std::string store) : folder_(std::move(folder)), named_(std::move(store)) {
        for (const std::string& id : task_ids()) tasks_.push_back(load_task(task_file(id)));
        curricula_.push_back(installed_curriculum());
    }
    database::Store* store() override { return store_.get(); }
    std::string store_path(bool demo) const override {
        if (!demo && !named_.empty()) return named_;
        if (folder_.empty()) return database::Store::default_path(demo);
        return (std::filesystem::path(folder_) / (demo ? "demo.db" : "fulcrum.db")).string();
    }
    void open_store(bool demo) override {
        const std::string path = store_path(demo);
        close_store();
        if (!demo && !database::ServerAddress::is_address(path) && database::Store::exists(path))
            database::require_quick_check(path);
        auto opened = std::make_unique<database::Store>(database::Store::open_or_create(path, demo));
        // Also where its file was put there since, by another program of the station.
        if (auto newer = newer_curriculum(*opened, curriculum())) curricula_.push_back(std::move(*newer));
        database::Curricula(*opened).check(curriculum());
        if (!demo && !opened->is_read_only()) database::erase_listed(*opened);
        store_ = std::move(opened);
        frames_swept_ = false;
    }
    void close_store() override {
        in_advance_.finish();
        store_.reset();
    }
    void choose_store(const std::string& path) override {
        close_store();
        named_ = path;
    }
    bool demo_is_built() const override { return database::Store::exists(store_path(true)); }
    bool unpack_demo(const ui::Progress& progress) override {
        return app::unpack_demo(store_path(true), progress);
    }
    const std::vector<TaskDefinition>& tasks() const override { return tasks_; }
    const Curriculum& curriculum() const override { return curricula_.back(); }
    void look_for_curriculum() override {
        if (auto newer = newer_curriculum(*store_, curriculum())) curricula_.push_back(std::move(*newer));
    }
    void publish_curriculum(const database::Session& session, const Curriculum& follows,
                            const std::string& text, const std::string& reason) override {
        const std::string folder = asset_path("curricula");
        database::publish_curriculum(*store_, session, {folder, all_installed_tasks(), forms()}, follows,
                                     text, reason);
        curricula_.push_back(installed_curriculum());
    }
    std::vector<ObserverForm> forms() const override { return load_forms(asset_path("forms")); }
    Scene scene_for(const TaskDefinition& task, const std::string& variant) const override {
        return load_task_and_scene({task.id, variant, {}}).scene;
    }
    std::string scene_text(const TaskDefinition& task, const std::string& variant) const override {
        return load_task_and_scene({task.id, variant, {}}).scene_text;
    }
    WorldSnapshot world_at_start(const TaskDefinition& task, const std::string& variant) const override {
        const LoadedTask loaded = load_task_and_scene({task.id, variant, {}});
        return AttemptEngine(loaded.scene, loaded.task, demonstration_seed).initial_snapshot();
    }

    std::unique_ptr<ui::AttemptSession> start_attempt(const ui::AttemptRequest& request) override {
        // The recorder checks again; checked here so that no scene is built for a refused attempt.
        store_->require(request.session, database::Operation::perform_attempt,
                        database::Subject::person(request.session.person_id()));
        if (request.assessed && request.practice_only)
            throw InputError(
                request.task_id, "",
                {QT_TRANSLATE_NOOP("errors", "this device is for practice only"), request.device},
                QT_TRANSLATE_NOOP("errors", "choose practice, or use another device"));
        if (request.from != nullptr) return begin_at_moment(request);
        if (request.goal > 0) return begin_at_goal(request);
        if (request.ghost && request.assessed)
            throw InputError(request.task_id, "",
                             QT_TRANSLATE_NOOP("errors", "an attempt with a ghost is for practice only"),
                             QT_TRANSLATE_NOOP("errors", "choose practice"));
        LoadedTask loaded = load_site_task(*store_, request.session, {request.task_id, request.variant, {}});
        if (request.assessed)
            database::require_assessed(*store_, request.session, request.session.person_id(), curriculum(),
                                       loaded.task, request.device_class);
        const Limits limits = limits_for(loaded.task, loaded.scene, request.device_class);
        const auto unknown =
            database::AcceptedAssets(*store_).unknown(assets_of(request.session, loaded, limits));
        if (request.assessed && !unknown.empty())
            throw InputError({QT_TRANSLATE_NOOP("errors", "task %1"), loaded.task.id}, "",
                             database::practice_only_words(unknown),
                             QT_TRANSLATE_NOOP("errors", "perform it as practice until then"));
        LiveRequest live;
        live.loaded = std::move(loaded);
        live.seed = request.seed;
        live.assessed = request.assessed;
        live.rig = request.rig;
        live.device = devices_.rig();
        live.store_path = store_->path();
        live.session = request.session;
        live.limits = limits;
        if (request.ghost) live.seed = demonstration_seed;
        if (live.seed == 0) live.seed = draw_seed();
        if (request.ghost) live.make_ghost = ghosts_.maker(live.loaded);
        live.meta = attempt_meta(live.loaded, live.seed,
                                 request.assessed ? AttemptMode::assessed : AttemptMode::practice,
                                 request.device_class, request.device, limits);
        note_curriculum(request.session, live.meta);
        live.meta.person_id = request.session.person_id();
        return begin(std::move(live));
    }
    Statement why_not_comparable(const database::Session& session, const std::string& task_id,
                                 DeviceClass device_class, const std::string& variant) override {
        const LoadedTask loaded = load_site_task(*store_, session, {task_id, variant, {}});
        return limits_for(loaded.task, loaded.scene, device_class).not_comparable;
    }
    std::vector<database::AssetFile> unknown_assets(const database::Session& session,
                                                    const std::string& task_id, DeviceClass device_class,
                                                    const std::string& variant) override {
        const LoadedTask loaded = load_site_task(*store_, session, {task_id, variant, {}});
        return database::AcceptedAssets(*store_).unknown(
            assets_of(session, loaded, limits_for(loaded.task, loaded.scene, device_class)));
    }
    std::vector<JudgedLimit> judged_limits(const database::Session& session, const std::string& task_id,
                                           DeviceClass device_class, const std::string& variant) override {
        const LoadedTask loaded = load_site_task(*store_, session, {task_id, variant, {}});
        const Limits limits = limits_for(loaded.task, loaded.scene, device_class);
        return fulcrum::judged_limits(loaded.task, limits.comparable(), limits.not_comparable);
    }
    std::unique_ptr<ui::AttemptSession> start_demonstration(const database::Session& session,
                                                            const std::string& task_id,
                                                            const std::string& variant) override {
        LiveRequest live;
        live.loaded = load_site_task(*store_, session, {task_id, variant, {}});
        live.seed = demonstration_seed;
        live.assessed = false;
        live.rig =
            make_operator(OperatorLevel::expert, live.loaded.task, live.loaded.scene, demonstration_seed);
        return begin(std::move(live));
    }
    std::vector<ui::InterruptedScore> score_interrupted(const database::Session& session,
                                                        const ui::Progress& progress) override {
        return app::score_interrupted(store_path(session.is_demo()), session, progress);
    }
    std::vector<database::StaleScore> stale_scores(const database::Session& session) override {
        database::StoreOptions options;
        options.read_only = true;
        const database::Store store = database::Store::open(store_path(session.is_demo()), options);
        return database::Attempts(store).stale_scores(session, scoring_in_force());
    }
    std::vector<RecomputedScore> recompute_scores(const database::Session& session,
                                                  const ui::Progress& progress) override {
        return fulcrum::recompute_scores(store_path(session.is_demo()), session, {}, progress);
    }
    database::CheckReport check_store(const database::Session& session,
                                      const ui::Progress& progress) override {
        database::StoreOptions options;
        options.read_only = true;
        const database::Store store = database::Store::open(store_path(session.is_demo()), options);
        SimulationSample sample;
        sample.seed = random_sample_seed();
        return check_store_and_sample(store, session, sample, progress);
    }
    Scene scene_of(const database::Session& session, const database::AttemptSummary& attempt) const override {
        return load_recorded(database::Attempts(*store_), session, attempt).scene;
    }
    std::unique_ptr<ui::ReplaySource> open_replay(const database::Session& session,
                                                  const database::AttemptSummary& attempt,
                                                  std::shared_ptr<const database::Trace> trace) override {
        const database::Attempts attempts(*store_);
        StoredStart stored = stored_start(attempts, session, attempt);
        ReplayRequest replay{std::move(stored.start), attempt.meta.id, std::move(trace),
                             attempt.meta.force_devices, stored.readable};
        replay.follower = follower_;
        replay.frames = in_advance_.take(attempt.meta.id);
        replay.open = open_replays_[attempt.meta.id].lock();
        if (replay.open == nullptr) replay.open = std::make_shared<char>();
        open_replays_[attempt.meta.id] = replay.open;
        replay.keeping = frames_of(session, attempt, replay.start.loaded);
        replay.tap = sending_.begin(replay.start.loaded.scene, replay.start.seed);
        return make_replay_source(std::move(replay));
    }
    void prepare_replays(const database::Session& session) override {
        if (store_ == nullptr || store_->is_server() || store_->is_read_only()) return;
        std::set<std::string> open;
        for (auto one = open_replays_.begin(); one != open_replays_.end();) {
            if (one->second.expired()) {
                one = open_replays_.erase(one);
            } else {
                open.insert((one++)->first);
            }
        }
        in_advance_.begin(store_->path(), session, std::move(open));
    }
    void stop_preparing_replays() override { in_advance_.stop(); }
    std::function<std::optional<ui::ExpertAttempt>(const ui::Progress&)> expert_attempt(
        const database::Session& session, const database::AttemptSummary& attempt) override {
        return expert_maker(load_recorded(database::Attempts(*store_), session, attempt), attempt.meta);
    }
    std::unique_ptr<ui::ReplaySource> open_expert_replay(const database::Session& session,
                                                         const database::AttemptSummary& attempt,
                                                         const ui::ExpertAttempt& expert) override {
        return make_replay_source(
            {{load_recorded(database::Attempts(*store_), session, attempt), expert.summary.meta.seed},
             {},
             expert.trace,
             expert.summary.meta.force_devices,
             true});
    }
    SiteTissues site_tissues(const database::Session& session, const std::string& task_id) override {
        return fulcrum::site_tissues(*store_, session, task_id);
    }
    void set_site_tissues(const database::Session& session, const std::string& task_id, int seen,
                          const database::TissueValues& values, const std::string& reason) override {
        fulcrum::set_site_tissues(*store_, session, task_id, seen, values, reason);
    }
    ui::SendingState sending() const override { return sending_.state(); }
    void choose_sending(bool wanted) override { sending_.choose(wanted); }
    ui::DeviceInUse device_in_use() const override { return devices_.in_use(); }
    std::shared_ptr<Rig> hands(const Scene& scene, std::shared_ptr<Rig> others) override {
        return devices_.hands(scene, std::move(others));
    }
    std::shared_ptr<GameController> game_controller() override { return devices_.game_controller(); }
    bool rumble_wanted() const override { return Devices::rumble_wanted(); }
    void set_rumble_wanted(bool wanted) override { Devices::set_rumble_wanted(wanted); }
    ui::SoundChoice sound_choice() const override { return Sounds::choice(); }
    void choose_sound(const ui::SoundChoice& choice) override { sounds_.choose(choice); }
    void play_sound(const SoundState& state) override { sounds_.play(state); }
    void test_sound() override { sounds_.test(); }
    Sentence sound_trouble() override { return sounds_.trouble(); }
    void open_device() override { devices_.open_now(); }
    void choose_device(const std::string& kind) override { devices_.choose(kind); }
    bool device_can_be_chosen() const override { return device_from_environment().empty(); }
    bool begins_at_ring(const std::string& kind) const override { return Devices::begins_at_ring(kind); }
    void set_begins_at_ring(const std::string& kind, bool wanted) override {
        Devices::set_begins_at_ring(kind, wanted);
    }
    bool can_calibrate(const std::string& kind) const override { return fulcrum::app::can_calibrate(kind); }
    std::string calibrated_at(const std::string& kind) const override {
        return fulcrum::app::calibrated_at(kind);
    }
    void start_calibration(int hand) override { devices_.start_calibration(hand); }
    ui::CalibrationState calibration() override { return devices_.calibration(); }
    void calibration_next() override {
        if (auto* running = devices_.running_calibration()) running->next();
    }
    void calibration_skip() override {
        if (auto* running = devices_.running_calibration()) running->skip();
    }
    void stop_calibration() override { devices_.stop_calibration(); }
    std::function<SceneReach()> scene_reach(const std::string& task_id) override {
        return [task_id] {
            const LoadedTask loaded = load_task_and_scene(task_id);
            return fulcrum::scene_reach(AttemptEngine(loaded.scene, loaded.task, 1));
        };
    }
    double motion_scale(const std::string& kind) const override { return Devices::motion_scale(kind); }
    void set_motion_scale(const std::string& kind, double scale) override {
        Devices::set_motion_scale(kind, scale);
    }
    ui::SlotChoice slot_choice(const std::string& kind) const override { return Devices::slot_choice(kind); }
    void set_slot_choice(const std::string& kind, const ui::SlotChoice& choice) override {
        Devices::set_slot_choice(kind, choice);
    }
    bool start_force_test() override { return devices_.start_force_test(); }
    void stop_force_test() override { devices_.stop_force_test(); }
    ui::ForceTestState force_test() override { return devices_.force_test(); }
    Sentence device_trouble() override { return devices_.trouble(); }
    std::function<std::vector<ui::ListedDevice>()> list_devices() override {
        const ui::SendingState now = sending_.state();
        return devices_of_machine(now.address);
    }
    std::optional<ui::DeviceReadings> device_readings() override { return devices_.readings(); }
    double force_scale(const std::string& kind) const override { return Devices::force_scale(kind); }
    void set_force_scale(const std::string& kind, double scale) override {
        Devices::set_force_scale(kind, scale);
    }
    std::string program_version() const override { return version_line(); }

  private:
    std::unique_ptr<ui::AttemptSession> begin(LiveRequest live) {
        in_advance_.stop();
        live.tap = sending_.begin(live.loaded.scene, live.seed);
        if (!live.store_path.empty()) {
            live.follower = std::make_shared<FrameFollower>();
            live.follower->replaces(std::move(follower_));
            follower_ = live.follower;
        }
        return std::make_unique<LiveAttempt>(std::move(live));
    }

    /// Practice that begins with the state that `bring` makes.
    std::unique_ptr<ui::AttemptSession> begin_from(
        const ui::AttemptRequest& request, LoadedTask loaded, std::uint64_t seed,
        database::AttemptOrigin origin, std::function<bool(AttemptEngine&, const std::atomic<bool>&)> bring) {
        if (request.assessed)
            throw InputError(
                request.task_id, "",
                QT_TRANSLATE_NOOP("errors", "an attempt that begins in the middle is for practice only"),
                QT_TRANSLATE_NOOP("errors", "choose practice"));
        const Limits limits = limits_for(loaded.task, loaded.scene, request.device_class);
        LiveRequest live;
        live.meta =
            attempt_meta(loaded, seed, AttemptMode::practice, request.device_class, request.device, limits);
        live.meta.person_id = request.session.person_id();
        live.meta.curriculum = followed_by(request.session).name();
        live.meta.origin = std::move(origin);
        live.meta.origin->build = state_build();
        live.loaded = std::move(loaded);
        live.seed = seed;
        live.assessed = false;
        live.rig = request.rig;
        live.device = devices_.rig();
        live.store_path = store_->path();
        live.session = request.session;
        live.limits = limits;
        live.bring = std::move(bring);
        if (request.ghost) live.make_ghost = ghosts_.maker(live.loaded);
        return begin(std::move(live));
    }
    std::unique_ptr<ui::AttemptSession> begin_at_moment(const ui::AttemptRequest& request) {
        const auto moment = std::dynamic_pointer_cast<const TraceMoment>(request.from);
        if (moment == nullptr)
            throw InputError(
                request.task_id, "",
                QT_TRANSLATE_NOOP("errors", "this moment does not belong to a replay that is open"),
                QT_TRANSLATE_NOOP("errors", "open the replay again"));
        database::AttemptOrigin origin;
        origin.source_id = moment->attempt_id;
        origin.goal = moment->goal;
        return begin_from(request, moment->loaded, moment->seed, std::move(origin),
                          [moment](AttemptEngine& engine, const std::atomic<bool>& stop) {
                              return moment->bring(engine, stop);
                          });
    }
    std::unique_ptr<ui::AttemptSession> begin_at_goal(const ui::AttemptRequest& request) {
        LoadedTask loaded = load_site_task(*store_, request.session, {request.task_id, request.variant, {}});
        if (request.goal >= static_cast<int>(loaded.task.goals.size()))
            throw InputError(request.task_id, "",
                             {QT_TRANSLATE_NOOP("errors", "has no goal %1"), request.goal + 1},
                             QT_TRANSLATE_NOOP("errors", "choose one of its goals"));
        database::AttemptOrigin origin;
        origin.goal = request.goal;
        return begin_from(request, std::move(loaded), demonstration_seed, std::move(origin),
                          [goal = request.goal](AttemptEngine& engine, const std::atomic<bool>& stop) {
                              const auto expert = make_operator(OperatorLevel::expert, engine.task(),
                                                                engine.scene(), engine.seed());
                              return perform_to_goal(engine, *expert, goal, [&stop] { return !stop.load(); });
                          });
    }

    static constexpr std::uint64_t demonstration_seed = 7;
    /// Outside 1000-1999, which are reserved for benchmarks.
    static std::uint64_t draw_seed() { return 2000 + std::random_device()() % (1000U * 1'000'000U); }
    std::string folder_, named_;  ///< of the stores; the store that the command line names
    std::vector<TaskDefinition> tasks_;
    /// Everything that decides what an attempt is worth.
    std::vector<database::AssetFile> assets_of(const database::Session& session, const LoadedTask& loaded,
                                               const Limits& limits) const {
        std::vector<database::AssetFile> files = loaded.assets;
        if (!limits.file.name.empty()) files.push_back(limits.file);
        files.push_back(file_of(followed_by(session)));
        return files;
    }
    const Curriculum& followed_by(const database::Session& session) const {
        return database::Curricula(*store_).in_force(session, session.person_id(), curriculum());
    }
    static database::AssetFile file_of(const Curriculum& curriculum) {
        return {"curricula/" + curriculum.file, database::sha256_hex(curriculum.text)};
    }
    /// The version that the person follows, which the first attempt settles.
    void note_curriculum(const database::Session& session, database::AttemptMeta& meta) const {
        const Curriculum& followed = followed_by(session);
        meta.curriculum = followed.name();
        meta.assets.push_back(file_of(followed));
    }
    std::list<Curriculum> curricula_;  ///< the newest last; pages hold on to those before it
    /// Where the key frames of this attempt's replay are kept.
    FrameKeeping frames_of(const database::Session& session, const database::AttemptSummary& attempt,
                           const LoadedTask& loaded) {
        if (!frames_swept_) database::remove_frames_without_attempt(*store_);
        frames_swept_ = true;
        return frame_keeping(*store_, session, attempt.meta.id, loaded);
    }

    std::unique_ptr<database::Store> store_;
    std::shared_ptr<FrameFollower> follower_;  ///< of the newest attempt
    FramesInAdvance in_advance_;
    std::map<std::string, std::weak_ptr<void>> open_replays_;  ///< by attempt
    bool frames_swept_ = false;  ///< once for each store opened: frames whose attempts are gone
    Ghosts ghosts_{demonstration_seed};
    Sending sending_;
    Sounds sounds_;
    Devices devices_{device_from_environment().empty() ? Devices::chosen() : device_from_environment()};
};

}  // namespace

std::string version_line() {
    return fulcrum::program_version;
}

std::unique_ptr<ui::ApplicationServices> make_services(const std::string& data_folder,
                                                       const std::string& store) {
    return std::make_unique<Services>(data_folder, store);
}

int run_window(const std::string& store) {
    const char* folder = std::getenv("FULCRUM_DATA");
    const auto services = make_services(folder != nullptr ? folder : "", store);
    const ui::Appearance look = ui::stored_appearance();
    auto& screen = *qobject_cast<QApplication*>(QCoreApplication::instance());
    ui::apply_theme(screen, look.theme);
    ui::apply_text_size(screen, look.text_percent);
    use_language_or(look.language);
    ui::MainWindow window(*services);
    window.show();
    auto* application = dynamic_cast<ui::WindowApplication*>(QCoreApplication::instance());
    if (application != nullptr)
        application->set_trouble([&](const QString& line) { window.context().complain(line); });
    window.start();
    const int status = QApplication::exec();
    if (application != nullptr) application->set_trouble({});
    return status;
}

}  // namespace fulcrum::app
