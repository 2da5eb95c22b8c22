// SPDX-License-Identifier: GPL-3.0-or-later
// The program's own services; a test may replace the device of the hands.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/services/application.h"

namespace fulcrum::app::program_test {

class ForwardingServices : public ui::ApplicationServices {
  public:
    explicit ForwardingServices(const std::string& folder) : own_(make_services(folder)) {}
    database::Store* store() override { return own_->store(); }
    std::string store_path(bool demo) const override { return own_->store_path(demo); }
    void open_store(bool demo) override { own_->open_store(demo); }
    void close_store() override { own_->close_store(); }
    void choose_store(const std::string& path) override { own_->choose_store(path); }
    bool demo_is_built() const override { return own_->demo_is_built(); }
    bool unpack_demo(const ui::Progress& progress) override { return own_->unpack_demo(progress); }
    const std::vector<TaskDefinition>& tasks() const override { return own_->tasks(); }
    const Curriculum& curriculum() const override { return own_->curriculum(); }
    void look_for_curriculum() override { own_->look_for_curriculum(); }
    void publish_curriculum(const database::Session& session, const Curriculum& follows,
                            const std::string& text, const std::string& reason) override {
        own_->publish_curriculum(session, follows, text, reason);
    }
    std::vector<ObserverForm> forms() const override { return own_->forms(); }
    std::function<std::optional<ui::ExpertAttempt>(const ui::Progress&)> expert_attempt(
        const database::Session& session, const database::AttemptSummary& attempt) override {
        return own_->expert_attempt(session, attempt);
    }
    std::unique_ptr<ui::ReplaySource> open_expert_replay(const database::Session& session,
                                                         const database::AttemptSummary& attempt,
                                                         const ui::ExpertAttempt& expert) override {
        return own_->open_expert_replay(session, attempt, expert);
    }
    Scene scene_for(const TaskDefinition& task, const std::string& variant) const override {
        return own_->scene_for(task, variant);
    }
    std::string scene_text(const TaskDefinition& task, const std::string& variant) const override {
        return own_->scene_text(task, variant);
    }
    WorldSnapshot world_at_start(const TaskDefinition& task, const std::string& variant) const override {
        return own_->world_at_start(task, variant);
    }
    std::vector<JudgedLimit> judged_limits(const database::Session& session, const std::string& task_id,
                                           DeviceClass device_class, const std::string& variant) override {
        return own_->judged_limits(session, task_id, device_class, variant);
    }
    void open_device() override { own_->open_device(); }
    void choose_device(const std::string& kind) override { own_->choose_device(kind); }
    bool device_can_be_chosen() const override { return own_->device_can_be_chosen(); }
    std::function<SceneReach()> scene_reach(const std::string& task_id) override {
        return own_->scene_reach(task_id);
    }
    bool can_calibrate(const std::string& kind) const override { return own_->can_calibrate(kind); }
    std::string calibrated_at(const std::string& kind) const override { return own_->calibrated_at(kind); }
    void start_calibration(int hand) override { own_->start_calibration(hand); }
    ui::CalibrationState calibration() override { return own_->calibration(); }
    void calibration_next() override { own_->calibration_next(); }
    void calibration_skip() override { own_->calibration_skip(); }
    void stop_calibration() override { own_->stop_calibration(); }
    bool begins_at_ring(const std::string& kind) const override { return own_->begins_at_ring(kind); }
    void set_begins_at_ring(const std::string& kind, bool wanted) override {
        own_->set_begins_at_ring(kind, wanted);
    }
    double motion_scale(const std::string& kind) const override { return own_->motion_scale(kind); }
    void set_motion_scale(const std::string& kind, double scale) override {
        own_->set_motion_scale(kind, scale);
    }
    ui::SlotChoice slot_choice(const std::string& kind) const override { return own_->slot_choice(kind); }
    void set_slot_choice(const std::string& kind, const ui::SlotChoice& choice) override {
        own_->set_slot_choice(kind, choice);
    }
    bool start_force_test() override { return own_->start_force_test(); }
    void stop_force_test() override { own_->stop_force_test(); }
    ui::ForceTestState force_test() override { return own_->force_test(); }
    std::shared_ptr<GameController> game_controller() override { return own_->game_controller(); }
    ui::SoundChoice sound_choice() const override { return own_->sound_choice(); }
    void choose_sound(const ui::SoundChoice& choice) override { own_->choose_sound(choice); }
    void play_sound(const SoundState& state) override {
        if (hears) own_->play_sound(heard ? heard(state) : state);
    }
    void test_sound() override { own_->test_sound(); }
    Sentence sound_trouble() override { return hears ? own_->sound_trouble() : Sentence(); }
    bool rumble_wanted() const override { return own_->rumble_wanted(); }
    void set_rumble_wanted(bool wanted) override { own_->set_rumble_wanted(wanted); }
    std::unique_ptr<ui::AttemptSession> start_attempt(const ui::AttemptRequest& request) override {
        ui::AttemptRequest asked = request;
        if (between) asked.rig = between(request.rig);
        if (seed != 0) asked.seed = seed;
        return own_->start_attempt(asked);
    }
    Statement why_not_comparable(const database::Session& session, const std::string& task_id,
                                 DeviceClass device_class, const std::string& variant) override {
        return own_->why_not_comparable(session, task_id, device_class, variant);
    }
    std::vector<database::AssetFile> unknown_assets(const database::Session& session,
                                                    const std::string& task_id, DeviceClass device_class,
                                                    const std::string& variant) override {
        return own_->unknown_assets(session, task_id, device_class, variant);
    }
    std::unique_ptr<ui::AttemptSession> start_demonstration(const database::Session& session,
                                                            const std::string& task_id,
                                                            const std::string& variant) override {
        return own_->start_demonstration(session, task_id, variant);
    }
    std::vector<ui::InterruptedScore> score_interrupted(const database::Session& session,
                                                        const ui::Progress& progress) override {
        return own_->score_interrupted(session, progress);
    }
    std::vector<database::StaleScore> stale_scores(const database::Session& session) override {
        return own_->stale_scores(session);
    }
    std::vector<RecomputedScore> recompute_scores(const database::Session& session,
                                                  const ui::Progress& progress) override {
        return own_->recompute_scores(session, progress);
    }
    database::CheckReport check_store(const database::Session& session,
                                      const ui::Progress& progress) override {
        return own_->check_store(session, progress);
    }
    std::unique_ptr<ui::ReplaySource> open_replay(const database::Session& session,
                                                  const database::AttemptSummary& attempt,
                                                  std::shared_ptr<const database::Trace> trace) override {
        return own_->open_replay(session, attempt, std::move(trace));
    }
    void prepare_replays(const database::Session& session) override { own_->prepare_replays(session); }
    void stop_preparing_replays() override { own_->stop_preparing_replays(); }
    Scene scene_of(const database::Session& session, const database::AttemptSummary& attempt) const override {
        return own_->scene_of(session, attempt);
    }
    SiteTissues site_tissues(const database::Session& session, const std::string& task_id) override {
        return own_->site_tissues(session, task_id);
    }
    void set_site_tissues(const database::Session& session, const std::string& task_id, int seen,
                          const database::TissueValues& values, const std::string& reason) override {
        own_->set_site_tissues(session, task_id, seen, values, reason);
    }
    ui::DeviceInUse device_in_use() const override { return own_->device_in_use(); }
    std::function<std::vector<ui::ListedDevice>()> list_devices() override { return own_->list_devices(); }
    std::optional<ui::DeviceReadings> device_readings() override { return own_->device_readings(); }
    double force_scale(const std::string& kind) const override { return own_->force_scale(kind); }
    void set_force_scale(const std::string& kind, double scale) override {
        own_->set_force_scale(kind, scale);
    }
    std::shared_ptr<Rig> hands(const Scene& scene, std::shared_ptr<Rig> others) override {
        return own_->hands(scene, std::move(others));
    }
    Sentence device_trouble() override { return own_->device_trouble(); }
    std::string program_version() const override { return own_->program_version(); }

    /// Gets the real device, returns the device that the attempt reads instead.
    std::function<std::shared_ptr<Rig>(std::shared_ptr<Rig>)> between;
    std::uint64_t seed = 0;  ///< of the next attempts; 0: drawn, as in the program
    bool hears = false;      ///< sound is played
    /// What is played in place of the state; empty: the state.
    std::function<SoundState(const SoundState&)> heard;

  private:
    std::unique_ptr<ui::ApplicationServices> own_;
};

}  // namespace fulcrum::app::program_test
