// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum demonstrate: performs one attempt, writes its report and a picture. ./run uses it without a
// display.
#include <QBuffer>
#include <QImage>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/live/performance.h"
#include "app/services/application.h"
#include "app/services/program.h"
#include "assessment/assets/assets.h"
#include "assessment/operators/operator.h"
#include "database/records/recorder.h"
#include "sim_core/numerics/files.h"
#include "ui/reports/report.h"
#include "ui/theatre/renderer/scene_assembler.h"

namespace fulcrum::app {
namespace {

/// The world after `seconds` of the attempt, performed again by the same operator with the same seed.
WorldSnapshot world_at(const LoadedTask& loaded, OperatorLevel level, std::uint64_t seed, double seconds) {
    AttemptEngine engine(loaded.scene, loaded.task, seed);
    const auto rig = make_operator(level, loaded.task, loaded.scene, seed);
    MemorySink sink;
    WorldSnapshot snapshot = engine.initial_snapshot();
    run_headless(
        engine, *rig, sink, [&](double simulated) { return simulated < seconds; },
        [&] { snapshot = engine.world().snapshot(); });
    return snapshot;
}

/// Performs the task in a new store and writes the performer's report; returns the attempt's duration (s).
double perform_and_report(const LoadedTask& loaded, std::uint64_t seed, const std::string& store_path,
                          const std::string& report_path) {
    const std::string& task = loaded.task.id;
    const Limits limits = limits_for(loaded.task, loaded.scene, DeviceClass::synthetic);
    database::Store store = database::Store::create(store_path, true);
    const database::Session station = store.station_session();
    const database::People people(store);
    const database::Person performer =
        people.ensure_synthetic(station, "demonstration", "Demonstration (synthetic expert)");
    const database::Person director =
        people.ensure_synthetic(station, "demonstration-director", "Demonstration director (synthetic)");
    people.set_demo_roles(station, performer.id, {database::Role::trainee});
    people.set_demo_roles(station, director.id, {database::Role::director});
    database::AttemptMeta meta = attempt_meta(loaded, seed, AttemptMode::assessed, DeviceClass::synthetic,
                                              "synthetic operator", limits);
    meta.person_id = performer.id;
    meta.operator_name = row_of(operator_levels, OperatorLevel::expert).name;
    database::Recorder recorder(store.path(), station, meta);
    PerformRequest request;
    request.loaded = loaded;
    request.operator_level = OperatorLevel::expert;
    request.seed = seed;
    const Performed performed = perform(request, &recorder, limits);
    const double duration = performed.scored.duration_s;
    std::cerr << "performed " << task << ": " << row_of(attempt_states, performed.scored.state).name
              << " after " << duration << " s, computed in " << performed.wall_s << " s\n";

    ui::ReportRequest report;
    report.person_id = performer.id;
    report.format = ui::ReportFormat::pdf;
    report.path = report_path;
    std::vector<TaskDefinition> tasks;
    for (const std::string& id : task_ids()) tasks.push_back(load_task(task_file(id)));
    ui::write_report(store, people.demo_session("demonstration-director", database::Role::director), report,
                     tasks, version_line());
    return duration;
}

/// Draws the scene at 40 % of the attempt. Throws InputError if the picture cannot be written.
void draw_moment(const LoadedTask& loaded, std::uint64_t seed, double duration, const std::string& path) {
    const WorldSnapshot snapshot = world_at(loaded, OperatorLevel::expert, seed, 0.4 * duration);
    ui::RendererOptions options;
    options.multisample = true;
    ui::SceneRenderer renderer(options);
    ui::SceneAssembler assembler(loaded.scene, snapshot);
    assembler.install(renderer);
    const QImage picture = ui::render_offscreen(renderer, assembler.assemble(snapshot), QSize(1280, 720));
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!picture.save(&buffer, "PNG")) throw std::runtime_error("the picture cannot be encoded as PNG");
    write_whole_file(path, bytes.toStdString());
}

int run_demonstrate(const Arguments& arguments) {
    const std::string task = arguments.words().empty() ? "B1" : arguments.words()[0];
    const auto seed = static_cast<std::uint64_t>(arguments.integer("--seed", 1, 0, 4000LL * 1'000'000));
    const LoadedTask loaded = load_task_and_scene(TaskRequest{task, arguments.value_or("--variant", ""), {}});
    const std::filesystem::path folder = arguments.folder("--output", "out");
    const std::string store_path = (folder / "demonstration.db").string();
    for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(store_path + suffix);

    const std::string report_path = (folder / "demonstration.pdf").string();
    const std::string picture_path = (folder / "demonstration.png").string();
    const double duration = perform_and_report(loaded, seed, store_path, report_path);
    draw_moment(loaded, seed, duration, picture_path);
    if (arguments.has("--json")) {
        print_json({{"task", task},
                    {"duration_s", duration},
                    {"report", report_path},
                    {"picture", picture_path},
                    {"store", store_path}});
    } else {
        std::cout << "wrote " << report_path << " and " << picture_path << '\n';
    }
    return 0;
}

}  // namespace

Command demonstrate_command() {
    return {
        "demonstrate",
        "[TASK]",
        0,
        1,
        QT_TRANSLATE_NOOP("commands",
                          "Lets a synthetic expert perform a task (B1) and writes its report and a picture."),
        {{"--output", "FOLDER", QT_TRANSLATE_NOOP("commands", "The folder to write to."), "out", {}, "-o"},
         seed_option(),
         variant_option(),
         json_option()},
        run_demonstrate,
        true};
}

}  // namespace fulcrum::app
