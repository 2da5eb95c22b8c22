// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of the theatre's picture, per task. Budget (docs/QUALITY.md): 33 ms per frame at 1280 x 720 in
// software, at most 20 ms of it drawing, while tick and world run on the same cores. Needs a display with
// OpenGL (xvfb-run). With a folder, the page is written into it as well.   usage: benchmark_theatre [FOLDER]
//
//   theatre/window/TASK    the product's own view in a window of that size; next to it a live attempt: an
//                          expert operator on the haptic thread's clock, the world's thread, the recorder's
//   theatre/pictures/TASK  the same pictures without window and threads; one thread's instruction counts
//                          compare (LP_NUM_THREADS=0 valgrind --tool=callgrind)
//   theatre/pictures/cut_bowel  a bowel with a slit and a disc that falls, and with the openings they leave;
//                          two of them stand in the page
//
// drawing: from asking for the picture until it is on the screen, wall time; cpu: what this thread and the
// software renderer's spent on it. FULCRUM_PICTURES names a folder for what theatre/pictures drew.
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QBuffer>
#include <QDir>
#include <QElapsedTimer>
#include <QPainter>
#include <QTemporaryDir>
#include <algorithm>
#include <ctime>
#include <fstream>
#include <thread>

#include "app/live/live_attempt.h"
#include "assessment/assets/assets.h"
#include "assessment/operators/operator.h"
#include "database/records/people.h"
#include "sim_core/lab/result_page.h"
#include "sim_core/lab/yardstick.h"
#include "tests/sim_core/world/parts/bowel/bowel_cut_rig.h"
#include "ui/theatre/renderer/offscreen.h"
#include "ui/theatre/renderer/picture.h"
#include "ui/theatre/renderer/scene_assembler.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::app {
namespace {

constexpr QSize window_size(1280, 720);
constexpr double frame_ms = 33.0;

double share(std::vector<double> values, double quantile) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1,
                           static_cast<std::size_t>(quantile * static_cast<double>(values.size())))];
}

/// CPU time of the calling thread and of the software renderer's own, ms.
double drawing_cpu_ms() {
    // Its own exactly; of the renderer's threads, which have gone to sleep by now, what is booked.
    timespec spent{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
    double sum = 1e3 * static_cast<double>(spent.tv_sec) + 1e-6 * static_cast<double>(spent.tv_nsec);
    const QString tasks = QStringLiteral("/proc/self/task/");
    for (const QString& thread : QDir(tasks).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        std::ifstream comm((tasks + thread + "/comm").toStdString());
        std::string name;
        std::getline(comm, name);
        if (name.rfind("llvmpipe", 0) != 0) continue;
        std::ifstream schedule((tasks + thread + "/schedstat").toStdString());
        double ns = 0;
        schedule >> ns;
        sum += 1e-6 * ns;
    }
    return sum;
}

/// Ticks of all processors since the machine started (/proc/stat): all, and those that its host gave to
/// others.
struct ProcessorTicks {
    double all = 0, stolen = 0;
};
ProcessorTicks processor_ticks() {
    std::ifstream stat("/proc/stat");
    std::string name;
    stat >> name;  // cpu  user nice system idle iowait irq softirq steal; guests are within user
    ProcessorTicks ticks;
    for (int column = 0; column < 8 && stat >> ticks.stolen; ++column) ticks.all += ticks.stolen;
    return ticks;
}
double stolen_percent(const ProcessorTicks& from, const ProcessorTicks& to) {
    return to.all > from.all ? 100 * (to.stolen - from.stolen) / (to.all - from.all) : 0;
}

double yardstick_ms() {
    std::vector<double> runs;
    for (int i = 0; i < 15; ++i) runs.push_back(1e-3 * lab::time_yardstick_us());
    return share(runs, 0.5);
}

void report(benchmark::State& state, const std::vector<double>& drawing, const std::vector<double>& cpu) {
    state.counters["drawing_ms"] = share(drawing, 0.5);
    state.counters["drawing_p99_ms"] = share(drawing, 0.99);
    state.counters["cpu_ms"] = share(cpu, 0.5);
    state.counters["cpu_p5_ms"] = share(cpu, 0.05);  // least disturbed by other programs
    state.counters["drawing_p5_ms"] = share(drawing, 0.05);
    state.counters["cpu_p99_ms"] = share(cpu, 0.99);
    state.counters["G_ms"] = yardstick_ms();
}

std::unique_ptr<LiveAttempt> start_attempt(const database::Store& store, const LoadedTask& loaded) {
    const database::Session session = store.station_session();
    const database::Person person = database::People(store).ensure_synthetic(session, "frames", "Frames");
    LiveRequest request;
    request.loaded = loaded;
    request.assessed = false;
    request.rig = make_operator(OperatorLevel::expert, loaded.task, loaded.scene, 1);
    request.store_path = store.path();
    request.session = session;
    request.meta =
        attempt_meta(loaded, 1, AttemptMode::practice, DeviceClass::synthetic, "synthetic operator", {});
    request.meta.person_id = person.id;
    request.meta.operator_name = "expert";
    return std::make_unique<LiveAttempt>(std::move(request));
}

void window(benchmark::State& state, const char* task) {
    const QTemporaryDir folder;
    const database::Store store =
        database::Store::create(folder.filePath(QStringLiteral("frames.db")).toStdString(), true);
    const LoadedTask loaded = load_task_and_scene(task);
    ui::TheatreView view;
    view.resize(window_size);
    view.set_paced(true);
    view.show();
    std::unique_ptr<LiveAttempt> attempt = start_attempt(store, loaded);
    while (attempt->phase() == ui::AttemptPhase::starting)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    attempt->update();
    view.load(attempt->scene(), attempt->snapshot());
    while (!view.is_loaded()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
    attempt->start();
    std::vector<double> drawing, cpu, interval, resolution;
    const ProcessorTicks ticks = processor_ticks();
    QElapsedTimer clock;
    clock.start();
    double next = 0, before = -1;
    const auto now_ms = [&clock] { return 1e-6 * static_cast<double>(clock.nsecsElapsed()); };
    for (auto _ : state) {
        // As on the theatre's page: poll, then one picture every 33 ms.
        while (now_ms() < next) {
            QCoreApplication::processEvents();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        next = std::max(next + frame_ms, now_ms());
        const double from = now_ms(), cpu_from = drawing_cpu_ms();
        attempt->update();
        ui::HudState hud;
        hud.task = &attempt->task();
        hud.display = attempt->display();
        hud.shows_active_hand = true;
        view.set_hud(hud);
        view.show_world(attempt->snapshot());
        view.repaint();
        QGuiApplication::sync();
        drawing.push_back(now_ms() - from);
        cpu.push_back(drawing_cpu_ms() - cpu_from);
        resolution.push_back(100 * view.resolution());
        if (before >= 0) interval.push_back(from - before);
        before = from;
        state.SetIterationTime(1e-3 * drawing.back());
    }
    state.counters["stolen_percent"] = stolen_percent(ticks, processor_ticks());
    const LoopStatistics kept = attempt->statistics();
    attempt->interrupt();
    attempt.reset();
    report(state, drawing, cpu);
    state.counters["frame_ms"] = share(interval, 0.5);
    state.counters["frame_p99_ms"] = share(interval, 0.99);
    state.counters["resolution_percent"] = share(resolution, 0.5);
    state.counters["resolution_least_percent"] = share(resolution, 0);
    state.counters["missed_by_program"] = static_cast<double>(kept.missed_by_program);
    state.counters["missed_by_scheduler"] = static_cast<double>(kept.missed_by_scheduler);
    state.counters["late_steps"] = static_cast<double>(kept.late_steps);
}

/// One snapshot per second of the world in the first 40 s of an expert's attempt.
std::vector<WorldSnapshot> recorded_worlds(const LoadedTask& loaded) {
    AttemptEngine engine(loaded.scene, loaded.task, 1);
    const auto rig = make_operator(OperatorLevel::expert, loaded.task, loaded.scene, 1);
    MemorySink sink;
    std::vector<WorldSnapshot> worlds = {engine.initial_snapshot()};
    int step = 0;
    run_headless(
        engine, *rig, sink, [](double simulated) { return simulated < 40; },
        [&] {
            if (++step % 200 == 0) worlds.push_back(engine.world().snapshot());
        });
    return worlds;
}

/// A slit in the bowel's wall and next to it a disc: just cut, falling, and gone.
std::vector<WorldSnapshot> cut_bowel_worlds(test::BowelCutRig& rig) {
    const Vector3 middle = rig.top_now();
    rig.cut_slit(rig.vertex_at(rig.top, -0.016, 0.004), 0.022);
    rig.cut_round(rig.vertex_at(rig.top, 0.010, 0.002), 0.007);
    std::vector<WorldSnapshot> worlds;
    for (int step = 1; step <= 210; ++step) {
        rig.step();
        if (step <= 10 || step % 20 == 0) worlds.push_back(rig.world.snapshot());
    }
    for (WorldSnapshot& world : worlds)
        world.camera =
            ui::camera_towards(middle + Vector3(0.004, 0.050, 0.062), middle, Vector3::UnitZ(), 0.8);
    return worlds;
}

std::vector<QImage> cut_bowel_kept;

/// Draws each world in turn, repeatedly. Returns the pictures of those in `keep`.
std::vector<QImage> draw_worlds(benchmark::State& state, const Scene& scene,
                                const std::vector<WorldSnapshot>& worlds,
                                const std::vector<std::size_t>& keep, QSize kept_size) {
    ui::OffscreenStage stage;
    ui::SceneRenderer renderer;
    ui::SceneAssembler assembler(scene, worlds[0]);
    assembler.install(renderer);
    stage.draw(renderer, assembler.assemble(worlds[0]), window_size);
    std::vector<double> drawing, cpu, assembling;
    std::size_t next = 0;
    QElapsedTimer clock;
    for (auto _ : state) {
        const double cpu_from = drawing_cpu_ms();
        clock.start();
        const ui::SceneFrame& frame = assembler.assemble(worlds[next++ % worlds.size()]);
        assembling.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
        stage.draw(renderer, frame, window_size);
        drawing.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
        cpu.push_back(drawing_cpu_ms() - cpu_from);
        state.SetIterationTime(1e-3 * drawing.back());
    }
    report(state, drawing, cpu);
    state.counters["assembling_ms"] = share(assembling, 0.5);
    std::vector<QImage> kept;
    for (const std::size_t w : keep) {
        if (w < worlds.size())
            kept.push_back(stage.picture(renderer, assembler.assemble(worlds[w]), kept_size));
    }
    stage.make_current();
    renderer.release();
    return kept;
}

void pictures(benchmark::State& state, const char* task) {
    const LoadedTask loaded = load_task_and_scene(task);
    const QString folder = qEnvironmentVariable("FULCRUM_PICTURES");
    const std::vector<std::size_t> keep =
        folder.isEmpty() ? std::vector<std::size_t>() : std::vector<std::size_t>{1, 12, 24, 36};
    const std::vector<QImage> kept =
        draw_worlds(state, loaded.scene, recorded_worlds(loaded), keep, window_size);
    for (std::size_t k = 0; k < kept.size(); ++k)
        kept[k].save(QStringLiteral("%1/%2-%3.png").arg(folder, QLatin1String(task)).arg(keep[k]));
}

constexpr const char* cut_bowel = "cut_bowel";

void cut_bowel_pictures(benchmark::State& state) {
    test::BowelCutRig rig;
    cut_bowel_kept = draw_worlds(state, rig.scene, cut_bowel_worlds(rig), {6, 19}, QSize(480, 480));
}

/// Two pictures next to each other.
lab::ResultFile cut_bowel_picture() {
    QImage both(static_cast<int>(cut_bowel_kept.size()) * 480, 480, QImage::Format_RGB32);
    QPainter painter(&both);
    for (std::size_t k = 0; k < cut_bowel_kept.size(); ++k)
        painter.drawImage(static_cast<int>(k) * 480, 0, cut_bowel_kept[k]);
    painter.end();
    QByteArray bytes;
    QBuffer buffer(&bytes);
    both.save(&buffer, "PNG");
    return {"theatre_cut_bowel.png", bytes.toStdString()};
}

/// Every task of assets/tasks.
const std::vector<std::string>& tasks() {
    static const std::vector<std::string> ids = task_ids();
    return ids;
}

/// Prints as usual and keeps the values for the page.
class Keeper : public benchmark::ConsoleReporter {
  public:
    Keeper() : ConsoleReporter(OO_None) {
        window.name = "theatre";
        window.columns = {"task",
                          "drawing, wall: median, ms",
                          "p99",
                          "drawing, processor: median, ms",
                          "least disturbed 5 %",
                          "frame to frame: median, ms",
                          "p99",
                          "resolution: median, %",
                          "least",
                          "ticks missed by the program",
                          "taken by the host, %",
                          "G, ms"};
        pictures.name = "theatre_pictures";
        pictures.columns = {"task", "processor: median, ms", "least disturbed 5 %",
                            "p99",  "in it geometry",        "G, ms"};
    }
    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (run.error_occurred) continue;
            const auto of = [&run](const char* counter) {
                char text[32];
                std::snprintf(text, sizeof text, "%.1f", run.counters.at(counter).value);
                return std::string(text);
            };
            const auto add_pictures = [&](const char* what) {
                if (run.benchmark_name().rfind(std::string("theatre/pictures/") + what, 0) == 0)
                    pictures.rows.push_back({what, of("cpu_ms"), of("cpu_p5_ms"), of("cpu_p99_ms"),
                                             of("assembling_ms"), of("G_ms")});
            };
            add_pictures(cut_bowel);
            for (const std::string& task : tasks()) {
                if (run.benchmark_name().rfind(std::string("theatre/window/") + task, 0) == 0) {
                    window.rows.push_back({task, of("drawing_ms"), of("drawing_p99_ms"), of("cpu_ms"),
                                           of("cpu_p5_ms"), of("frame_ms"), of("frame_p99_ms"),
                                           of("resolution_percent"), of("resolution_least_percent"),
                                           of("missed_by_program"), of("stolen_percent"), of("G_ms")});
                }
                add_pictures(task.c_str());
            }
        }
    }
    lab::ResultTable window, pictures;
};

void write_page(const std::string& folder, const Keeper& keeper, double load) {
    lab::ResultPage page("theatre", "What the theatre's picture costs",
                         "xvfb-run -a -s '-screen 0 1280x800x24' benchmark_theatre " + folder);
    char beside[512];
    std::snprintf(
        beside, sizeof beside,
        "1280 x 720, software rendering (llvmpipe) on the same cores as all other threads. Budget: 33 ms per "
        "frame, of which at most 20 ms are drawing. Load average of the machine over the minute before the "
        "run: %.1f. G is the yardstick in the same process, about 3 ms on a 2.6 GHz core that "
        "does nothing else; the least disturbed 5 %% is what neighbours on the cores slowed least.",
        load);
    page.paragraph(beside);
    page.paragraph(
        "The theatre view in a window during a live attempt of a synthetic expert, with haptic, world and "
        "recorder threads running. Drawing is measured from the request for a picture until it is on the "
        "screen; its processor time is that of this thread and of the software renderer. Resolution is the "
        "resolution of the scene along each side as a share of the window's: at most 70 %, in scenes with "
        "walls all round 58 %, and less if drawing takes long. Text is drawn at the full resolution of the "
        "window. The last share is the processor time that the host of the virtual machine gave to other "
        "machines during the run.");
    page.table(keeper.window);
    page.paragraph("The scene alone, drawn offscreen, over the first 40 s of the same attempt.");
    page.table(keeper.pictures);
    if (!cut_bowel_kept.empty()) {
        page.paragraph(
            "cut_bowel: the bowel wall in scene bowel_enterotomy after two cuts, a slit along the bowel and "
            "a disc. Left: while the disc falls into the lumen. Right: after it is gone.");
        page.file(cut_bowel_picture(), "A slit in the wall of a bowel and a round opening into it.");
    }
    page.write(folder, lab::this_machine(lab::build_info()));
}

}  // namespace
}  // namespace fulcrum::app

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    QApplication application(argc, argv);
    double load = 0;
    if (getloadavg(&load, 1) != 1) load = 0;
    for (const std::string& task : fulcrum::app::tasks()) {
        benchmark::RegisterBenchmark((std::string("theatre/window/") + task).c_str(), fulcrum::app::window,
                                     task.c_str())
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond)
            ->Iterations(240);
        benchmark::RegisterBenchmark((std::string("theatre/pictures/") + task).c_str(),
                                     fulcrum::app::pictures, task.c_str())
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond)
            ->Iterations(120);
    }
    benchmark::RegisterBenchmark((std::string("theatre/pictures/") + fulcrum::app::cut_bowel).c_str(),
                                 fulcrum::app::cut_bowel_pictures)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond)
        ->Iterations(120);
    fulcrum::app::Keeper keeper;
    benchmark::RunSpecifiedBenchmarks(&keeper);
    if (argc > 1) fulcrum::app::write_page(argv[1], keeper, load);
    return 0;
}
