// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/fake_services.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum_draft.h"
#include "database/records/people.h"
#include "database/store/quick_check.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "tests/support/support.h"

namespace fulcrum::ui::window_test {
namespace {

WorldSnapshot first_world(const Scene& scene) {
    WorldSnapshot world;
    for (const InstrumentSpec& spec : scene.instruments) {
        DeviceSample sample;
        sample.handle[2] = -static_cast<std::int32_t>((spec.trocar.shaft_length - spec.start_insertion) /
                                                      device_length_unit);
        world.tools[static_cast<int>(spec.hand)] =
            tool_pose(make_instrument(spec, scene.tick_period()), sample).pose();
    }
    if (scene.camera) {
        DeviceSample sample;
        sample.handle[2] = -static_cast<std::int32_t>(
            (scene.camera->trocar.shaft_length - scene.camera->start_insertion) / device_length_unit);
        world.camera = scope_pose(make_scope(*scene.camera), sample);
    }
    if (scene.targets) {
        const TargetFieldSpec& field = *scene.targets;
        for (int hand = 0; hand < hand_count; ++hand) {
            for (int i = 0; i < field.per_hand; ++i) {
                const double u = (i + 0.5) / field.per_hand * 2 - 1, v = std::sin(2.4 * i + hand);
                const Vector3 offset(u * field.half_extent.x(), v * field.half_extent.y(),
                                     std::cos(1.7 * i) * field.half_extent.z());
                world.targets.push_back({field.centre + offset, field.radius, static_cast<Hand>(hand)});
            }
        }
    }
    return world;
}

class FakeAttempt : public AttemptSession {
  public:
    FakeAttempt(const AttemptRequest& request, const TaskDefinition& task, Scene scene,
                const std::string& store_path, database::StoreOptions options, AttemptControl& control)
        : request_(request), task_(task), scene_(std::move(scene)), control_(control) {
        database::AttemptMeta meta;
        meta.person_id = request.session.person_id();
        meta.task_id = task.id;
        meta.mode = request.assessed ? AttemptMode::assessed : AttemptMode::practice;
        meta.device_class = request.device_class;
        meta.device = request.device;
        meta.variant = scene_.variant;
        meta.fidelity = "standard";
        meta.scene = task.scene;
        meta.seed = 7;
        meta.limits = task.id + "-operators@1";
        meta.program_version = "0.1.0-test";
        recorder_ =
            std::make_unique<database::Recorder>(store_path, request.session, meta, std::move(options));
        world_ = first_world(scene_);
        for (const InstrumentSpec& spec : scene_.instruments) {
            model_[static_cast<int>(spec.hand)] = make_instrument(spec, scene_.tick_period());
        }
        add_event(EventKind::attempt_begin);
        display_.remaining_s = task.time_limit_s;
        display_.active_target = world_.targets.empty() ? -1 : 0;
    }
    ~FakeAttempt() override {
        if (!outcome_) end(AttemptState::interrupted, EventKind::interrupted);
    }
    const Scene& scene() const override { return scene_; }
    const TaskDefinition& task() const override { return task_; }
    bool assessed() const override { return request_.assessed; }
    bool became_practice() const override { return false; }
    AttemptPhase phase() const override { return phase_; }
    void start() override { phase_ = AttemptPhase::running; }
    Realignment realignment() override { return control_.realignment; }
    bool update() override;
    const WorldSnapshot& snapshot() const override { return world_; }
    const TaskDisplay& display() const override { return display_; }
    LoopHealth health() const override { return {tick_, 0, 0, 0, {false, false}}; }
    void pause() override {
        phase_ = AttemptPhase::paused;
        add_event(EventKind::pause);
    }
    void resume() override {
        if (phase_ == AttemptPhase::device_lost && control_.drop_device) return;
        if (phase_ == AttemptPhase::device_lost) add_event(EventKind::device_back);
        phase_ = AttemptPhase::running;
        add_event(EventKind::resume);
    }
    void abandon() override { end(AttemptState::abandoned, EventKind::abandoned); }
    void interrupt() override { end(AttemptState::interrupted, EventKind::interrupted); }
    Sentence message() const override {
        return phase_ == AttemptPhase::device_lost ? "The device does not answer; reconnect it to resume."
                                                   : "";
    }
    const std::optional<AttemptOutcome>& outcome() const override { return outcome_; }

  private:
    void add_event(EventKind kind, int hand = 255, float value = 0, int detail = 0, int tissue = -1) {
        Event event;
        event.tick = tick_;
        event.kind = kind;
        event.hand = static_cast<std::uint8_t>(hand);
        event.value = value;
        event.detail = detail;
        event.tissue = static_cast<std::int8_t>(tissue);
        recorder_->append(event);
        ++events_;
    }
    void one_tick();
    database::ScoreRow score(AttemptState state) const;
    void end(AttemptState state, EventKind kind);

    AttemptRequest request_;
    TaskDefinition task_;
    Scene scene_;
    AttemptControl& control_;
    std::unique_ptr<database::Recorder> recorder_;
    WorldSnapshot world_;
    TaskDisplay display_;
    InstrumentModel model_[hand_count];
    AttemptPhase phase_ = AttemptPhase::ready;
    std::optional<AttemptOutcome> outcome_;
    std::uint32_t tick_ = 0;
    std::uint64_t events_ = 0;
    double path_[hand_count] = {0, 0}, over_ = 0, worst_force_ = 0;
    Vector3 last_[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    bool over_force_ = false;
};

void FakeAttempt::one_tick() {
    ++tick_;
    RigSample input;
    request_.rig->read(tick_, input);
    TickSample sample;
    sample.tick = tick_;
    for (int h = 0; h < hand_count; ++h) {
        const ToolKinematics tool = tool_pose(model_[h], input.hand[h]);
        world_.tools[h] = tool.pose();
        if (tick_ > 1) path_[h] += (tool.tip - last_[h]).norm();
        last_[h] = tool.tip;
        HandSample& hand = sample.hand[h];
        for (int axis = 0; axis < 3; ++axis) {
            hand.tip[axis] = static_cast<std::int32_t>(std::lround(tool.tip[axis] / sample_length_unit));
            hand.axis[axis] = static_cast<std::int32_t>(std::lround(tool.axis[axis] / sample_axis_unit));
        }
        hand.jaw_angle = input.hand[h].jaw;
        const bool pressing = h == 0 && control_.press_hard;
        const double force = pressing ? 9.0 : 0.4 + 0.3 * std::sin(tick_ * 0.01 + h);
        hand.force[2] = static_cast<std::int32_t>(force / sample_force_unit);
        hand.flags = hand_inside | hand_in_view;
        display_.force[h] = static_cast<float>(force);
        display_.force_limit[h] = pressing ? 4.0F : 0.0F;
        display_.warning[h] = pressing;
        worst_force_ = std::max(worst_force_, force);
        if (pressing) over_ += 5.0 * 1e-3;
    }
    if (control_.press_hard != over_force_) {
        over_force_ = control_.press_hard;
        add_event(over_force_ ? EventKind::over_force_begin : EventKind::over_force_end, 0, 9.0F, 4000, 0);
    }
    if (!display_.moving_seen && path_[0] + path_[1] > 0.002) {
        display_.moving_seen = true;
        add_event(EventKind::first_movement);
    }
    recorder_->append(input);
    recorder_->append(sample);
}

bool FakeAttempt::update() {
    if (phase_ == AttemptPhase::device_lost && !control_.drop_device) return true;
    if (phase_ != AttemptPhase::running) return true;
    if (control_.drop_device) {
        phase_ = AttemptPhase::device_lost;
        add_event(EventKind::device_lost);
        return true;
    }
    for (int i = 0; i < control_.ticks_per_update; ++i) one_tick();
    display_.elapsed_s = tick_ * 1e-3;
    display_.remaining_s = task_.time_limit_s - display_.elapsed_s;
    if (display_.active_target >= 0) {
        const int shown = static_cast<int>(display_.elapsed_s / 2.0);
        if (shown > display_.active_target && shown < 10) {
            add_event(EventKind::target_reached, 0, 0, display_.active_target, 0);
            display_.active_target = shown;
        }
        display_.goal_progress = std::min(shown, 10) / 10.0;
    }
    world_.tick = tick_;
    if (control_.complete) end(AttemptState::completed, EventKind::completed);
    return true;
}

database::ScoreRow FakeAttempt::score(AttemptState state) const {
    database::ScoreRow row;
    row.program_version = "0.1.0-test";
    row.limits = task_.id + "-operators@1";
    const auto metric = [](const char* id, const char* hand, double value, const char* unit) {
        database::MetricRow one;
        one.id = id;
        one.hand = hand;
        one.value = value;
        one.unit = unit;
        one.direction = Direction::lower;
        one.evidence = {{0.5, 1.0}};
        return one;
    };
    row.metrics = {metric("time", "", tick_ * 1e-3, "s"),
                   metric("path_len", "left", path_[0] * 1e3, "mm"),
                   metric("path_len", "right", path_[1] * 1e3, "mm"),
                   metric("over_impulse", "left", over_, "N·s"),
                   metric("over_impulse", "right", 0, "N·s"),
                   metric("f_max", "left", worst_force_, "N")};
    database::MetricRow absent = metric("sparc", "left", 0, "-");
    absent.value.reset();
    absent.absent_because = {StatementId::few_movements, {{"count", 3.0}, {"least", 5.0}}};
    row.metrics.push_back(absent);
    const bool force_met = worst_force_ <= 4.0;
    const bool done = state == AttemptState::completed;
    database::GateRow time{
        "time", "",   "", GateKind::benchmark, tick_ * 1e-3, "s", 120.0, task_.id + "-operators@1", 0.8, 75.0,
        true,   true, {}};
    database::GateRow force{"f_max",
                            "left",
                            "",
                            GateKind::absolute,
                            worst_force_,
                            "N",
                            4.0,
                            "training limit, provisional",
                            std::nullopt,
                            std::nullopt,
                            force_met,
                            true,
                            {}};
    row.gates = {time, force};
    row.passed = done && force_met;
    row.points = 75.0;
    const std::string force_metric = "f_max", left = "left";
    row.advice =
        force_met
            ? Statement(StatementId::gates_met)
            : Statement(StatementId::gate_missed,
                        {{"metric", force_metric}, {"hand", left}, {"value", worst_force_}, {"limit", 4.0}});
    return row;
}

void FakeAttempt::end(AttemptState state, EventKind kind) {
    if (outcome_) return;
    add_event(kind);
    database::AttemptResult result;
    result.state = state;
    result.duration_s = tick_ * 1e-3;
    result.wall_s = tick_ * 1e-3;
    result.state_hash = "00ff";
    if (state != AttemptState::interrupted) result.score = score(state);
    recorder_->finish(result);
    outcome_ = AttemptOutcome{recorder_->attempt_id(), state, result.duration_s, 0, 0};
    control_.last_attempt_id = recorder_->attempt_id();
    display_.ended = true;
    display_.end = kind;
    phase_ = AttemptPhase::finished;
}

class FakeReplay : public ReplaySource {
  public:
    FakeReplay(Scene scene, const std::shared_ptr<const database::Trace>& trace)
        : scene_(std::move(scene)),
          ticks_(database::ticks_of(trace)),
          reader_(ticks_->reader()),
          world_(first_world(scene_)) {}
    const Scene& scene() const override { return scene_; }
    double duration_s() const override { return ticks_->size() == 0 ? 0 : ticks_->last_sample().tick * 1e-3; }
    void seek(double time_s) override {
        time_ = time_s;
        fresh_ = true;
    }
    bool update() override {
        if (!fresh_) return false;
        fresh_ = false;
        const auto index = std::min(static_cast<std::size_t>(time_ * 1000), ticks_->size() - 1);
        for (int h = 0; h < hand_count; ++h) {
            const HandSample& hand = reader_->sample(index).hand[h];
            for (int axis = 0; axis < 3; ++axis) {
                world_.tools[h].tip[axis] = hand.tip[axis] * sample_length_unit;
                world_.tools[h].axis[axis] = hand.axis[axis] * sample_axis_unit;
            }
        }
        return true;
    }
    const WorldSnapshot& snapshot() const override { return world_; }
    double shown_s() const override { return time_; }
    double ready() const override { return 1; }
    std::optional<double> differs_from_s() const override { return std::nullopt; }
    std::shared_ptr<const ReplayMoment> moment(double /*time_s*/) const override { return nullptr; }

  private:
    Scene scene_;
    std::shared_ptr<const RecordTicks> ticks_;
    std::unique_ptr<TickReader> reader_;
    WorldSnapshot world_;
    double time_ = 0;
    bool fresh_ = true;
};

}  // namespace

FakeServices::FakeServices() {
    // The delivered files, read once in a process.
    static const std::vector<TaskDefinition> tasks = [] {
        std::vector<TaskDefinition> all;
        for (const std::string& id : fulcrum::task_ids())
            all.push_back(load_task(fulcrum::test::source_path("assets/tasks/" + id + ".json")));
        return all;
    }();
    static const Curriculum curriculum =
        load_versions(fulcrum::test::source_path("assets/curricula"), "rectal", fulcrum::task_ids());
    tasks_ = tasks;
    curriculum_ = curriculum;
}

database::CurriculumPublishing FakeServices::curricula_place() {
    namespace fs = std::filesystem;
    const fs::path folder = folder_.filePath(QStringLiteral("curricula")).toStdString();
    if (fs::create_directory(folder))
        for (const auto& file : fs::directory_iterator(fulcrum::test::source_path("assets/curricula")))
            fs::copy_file(file.path(), folder / file.path().filename());
    std::vector<InstalledTask> installed;
    for (const TaskDefinition& task : tasks_) installed.push_back(installed_task(task));
    return {folder.string(), installed, forms()};
}

void FakeServices::publish_curriculum(const database::Session& session, const Curriculum& follows,
                                      const std::string& text, const std::string& reason) {
    const database::CurriculumPublishing place = curricula_place();
    database::publish_curriculum(*store_, session, place, follows, text, reason);
    published_.push_back(load_versions(place.folder, follows.id, fulcrum::task_ids()));
}

void FakeServices::publish_elsewhere(const database::Session& session,
                                     const std::function<void(Curriculum&)>& change) {
    const database::CurriculumPublishing place = curricula_place();
    const Curriculum follows = load_versions(place.folder, curriculum().id, fulcrum::task_ids());
    Curriculum next = follows;
    change(next);
    next.version = follows.next_own_version();
    database::publish_curriculum(*store_, session, place, follows, curriculum_text(next), "by a colleague");
}

void FakeServices::look_for_curriculum() {
    const std::string folder = folder_.filePath(QStringLiteral("curricula")).toStdString();
    if (!std::filesystem::exists(folder)) return;
    Curriculum now = load_versions(folder, curriculum().id, fulcrum::task_ids());
    if (now.text != curriculum().text) published_.push_back(std::move(now));
}

std::vector<ObserverForm> FakeServices::forms() const {
    static const std::vector<ObserverForm> all = load_forms(fulcrum::test::source_path("assets/forms"));
    return all;
}

std::string FakeServices::store_path(bool demo) const {
    if (!demo && !chosen_store.empty()) return chosen_store;
    return folder_.filePath(demo ? QStringLiteral("demo.db") : QStringLiteral("fulcrum.db")).toStdString();
}

void FakeServices::open_store(bool demo) {
    const std::string path = store_path(demo);
    store_.reset();
    if (!demo && database::Store::exists(path)) database::require_quick_check(path);
    store_ = std::make_unique<database::Store>(
        database::Store::exists(path) ? database::Store::open(path) : database::Store::create(path, demo));
}

bool FakeServices::unpack_demo(const Progress& progress) {
    const database::Store demo = database::Store::create(store_path(true), true);
    const database::People people(demo);
    std::vector<std::string> members, educators;
    for (const auto& [login, name, role] :
         {std::tuple{"nova", "Nova (synthetic)", database::Role::trainee},
          std::tuple{"iris", "Iris (synthetic)", database::Role::educator},
          std::tuple{"dora", "Dora (synthetic)", database::Role::director}}) {
        const database::Person person = people.ensure_synthetic(demo.station_session(), login, name);
        people.set_demo_roles(demo.station_session(), person.id, {role});
        (role == database::Role::trainee ? members : educators).push_back(person.id);
    }
    people.create_demo_cohort(demo.station_session(), "Demonstration", members, {educators.front()});
    if (progress && !progress(0.9, "")) return false;
    database::Store sealed = database::Store::open(store_path(true));
    sealed.seal_demo(sealed.station_session());
    return true;
}

Scene FakeServices::scene_for(const TaskDefinition& task, const std::string& variant) const {
    return load_scene(fulcrum::test::source_path("assets/scenes/" + require_variant(task, variant).scene));
}

std::string FakeServices::scene_text(const TaskDefinition& task, const std::string& variant) const {
    if (broken_scene) throw InputError(*broken_scene);
    return read_text_file(fulcrum::test::source_path("assets/scenes/" + require_variant(task, variant).scene),
                          JsonLimits().bytes);
}

WorldSnapshot FakeServices::world_at_start(const TaskDefinition& task, const std::string& variant) const {
    ++worlds_built;
    return first_world(scene_for(task, variant));
}

std::vector<JudgedLimit> FakeServices::judged_limits(const database::Session&, const std::string& task_id,
                                                     DeviceClass, const std::string& variant) {
    judged_variant = variant;
    for (const TaskDefinition& task : tasks_) {
        if (task.id != task_id) continue;
        const std::string path = fulcrum::test::source_path("assets/benchmarks/" + task_id + ".json");
        if (!std::filesystem::exists(path)) return fulcrum::judged_limits(task, nullptr);
        const BenchmarkSet set = load_benchmark(path);
        return fulcrum::judged_limits(task, &set);
    }
    throw InputError("limits", task_id, "unknown task", "choose one of the tasks");
}

std::unique_ptr<AttemptSession> FakeServices::start_attempt(const AttemptRequest& request) {
    control = AttemptControl();
    for (const TaskDefinition& task : tasks_) {
        if (task.id == request.task_id) {
            return std::make_unique<FakeAttempt>(request, task, scene_for(task, request.variant),
                                                 store_->path(), database::StoreOptions(), control);
        }
    }
    throw InputError("attempt", request.task_id, "unknown task", "choose one of the tasks");
}

std::unique_ptr<AttemptSession> FakeServices::start_demonstration(const database::Session&,
                                                                  const std::string& task_id,
                                                                  const std::string&) {
    throw InputError("demonstration", task_id, "no operator without physics",
                     "use the program's own services");
}

Scene FakeServices::scene_of(const database::Session&, const database::AttemptSummary& attempt) const {
    for (const TaskDefinition& task : tasks_) {
        if (task.id == attempt.meta.task_id) return scene_for(task, attempt.meta.variant);
    }
    throw InputError("replay", attempt.meta.task_id, "unknown task", "update the program");
}

std::unique_ptr<ReplaySource> FakeServices::open_replay(const database::Session& session,
                                                        const database::AttemptSummary& attempt,
                                                        std::shared_ptr<const database::Trace> trace) {
    if (broken_scene) throw InputError(*broken_scene);
    return std::make_unique<FakeReplay>(scene_of(session, attempt), trace);
}

std::function<std::optional<ExpertAttempt>(const Progress&)> FakeServices::expert_attempt(
    const database::Session& session, const database::AttemptSummary& attempt) {
    if (expert_waits)
        return [](const Progress& progress) -> std::optional<ExpertAttempt> {
            while (progress(0.5, {})) std::this_thread::sleep_for(std::chrono::milliseconds(5));
            return std::nullopt;
        };
    if (expert) return [made = expert](const Progress&) { return made; };
    // The attempt itself.
    const database::Attempts attempts(*store_);
    ExpertAttempt same{attempt, attempts.score(session, attempt.meta.id).value_or(database::ScoreRow()),
                       std::make_shared<const database::Trace>()};
    if (attempt.meta.keep_trace)
        same.trace = std::make_shared<const database::Trace>(attempts.read_trace(session, attempt.meta.id));
    same.summary.meta.id.clear();
    return [same](const Progress&) { return std::optional<ExpertAttempt>(same); };
}

void FakeServices::set_site_tissues(const database::Session&, const std::string& task_id, int,
                                    const database::TissueValues&, const std::string&) {
    throw InputError("tissues", task_id, "nothing is cut here", "use the program's own services");
}

}  // namespace fulcrum::ui::window_test
