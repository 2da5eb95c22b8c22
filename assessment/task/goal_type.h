// SPDX-License-Identifier: Apache-2.0
// Every kind of goal: its name in task files, what a task must say about it, what the scene must have, and
// what follows its progress. A new kind is a row here, a tracker (assessment/task/goals), a behaviour of the
// synthetic operators (assessment/operators) and its line on the HUD (ui/theatre/hud.cpp).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "sim_core/numerics/name_table.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum {

struct Goal;
struct Scene;
struct GoalWatch;
class GoalTracker;

enum class GoalKind : std::uint8_t {
    touch_targets,  ///< touch and hold each sphere of one hand, in order (A2)
    run_bowel,      ///< run a length of bowel hand over hand (B1)
    lift_and_hold,  ///< lift a stretch of bowel above its resting height and hold it (B1)
    take_tension,   ///< take hold of the sheet and keep the traction across its marked line in the band (B2,
                    ///< C4: the rectum is held)
    divide_line,    ///< divide the sheet, or septum after septum, along its marked line (B2, C4)
    let_go,         ///< hold nothing and cut nothing (B2, C4)
    divide_bands,   ///< divide a number of bands (B3)
    stop_bleeding,  ///< every vessel divided, none of them bleeding for a while (B3)
    palpate,        ///< rest an instrument on a stretch of bowel, in contact for a while (B0)
    transfer_objects,  ///< hand rings over in the air and put them around pegs (A3)
    frame_targets,     ///< frame each target in the middle, level and at its size, in order (A1)
    follow_tip,        ///< keep a tip that moves in the middle (A1)
};

/// The part of a scene that a goal works on. Synthetic operators have one behaviour for each.
enum class GoalSite : std::uint8_t { targets, bowel, sheet, bands, objects, camera_targets };
/// What goal_progress events of a goal count.
enum class GoalMeasure : std::uint8_t { count, metres, seconds };

/// A key that a task must give for a goal, and what it means.
struct GoalKey {
    const char* name = nullptr;
    const char* meaning = nullptr;
};
/// What is wrong with a goal.
struct GoalFault {
    std::string key;  ///< of the task file, "" the goal as a whole
    Sentence problem, hint;
};

struct GoalType {
    GoalKind kind;
    const char* name;
    const char* title;
    GoalSite site;
    GoalMeasure measure;
    bool traction;  ///< the traction across the line is shown with its band
    std::array<GoalKey, 6> keys;
    /// What the keys cannot say; null: nothing.
    std::optional<GoalFault> (*check)(const Goal&);
    /// Whether a scene has what the goal needs beyond its site; null: nothing more.
    std::optional<GoalFault> (*suits)(const Goal&, const Scene&);
    std::unique_ptr<GoalTracker> (*tracker)(const Goal&, const GoalWatch&);
};

namespace goals {

std::unique_ptr<GoalTracker> track_targets(const Goal& goal, const GoalWatch& watch);
std::optional<GoalFault> targets_suit(const Goal& goal, const Scene& scene);

std::unique_ptr<GoalTracker> track_run(const Goal& goal, const GoalWatch& watch);
std::optional<GoalFault> check_run(const Goal& goal);
std::optional<GoalFault> on_bowel(const Goal& goal, const Scene& scene);

std::unique_ptr<GoalTracker> track_lift(const Goal& goal, const GoalWatch& watch);
std::optional<GoalFault> check_stretch(const Goal& goal);

std::unique_ptr<GoalTracker> track_tension(const Goal& goal, const GoalWatch& watch);
std::unique_ptr<GoalTracker> track_line(const Goal& goal, const GoalWatch& watch);
std::unique_ptr<GoalTracker> track_let_go(const Goal& goal, const GoalWatch& watch);
std::optional<GoalFault> check_traction(const Goal& goal);
std::optional<GoalFault> check_line(const Goal& goal);
std::optional<GoalFault> line_suits(const Goal& goal, const Scene& scene);

std::unique_ptr<GoalTracker> track_bands(const Goal& goal, const GoalWatch& watch);
std::unique_ptr<GoalTracker> track_bleeding(const Goal& goal, const GoalWatch& watch);
std::optional<GoalFault> enough_bands(const Goal& goal, const Scene& scene);
std::optional<GoalFault> enough_vessels(const Goal& goal, const Scene& scene);

std::unique_ptr<GoalTracker> track_palpation(const Goal& goal, const GoalWatch& watch);

std::unique_ptr<GoalTracker> track_transfer(const Goal& goal, const GoalWatch& watch);
std::optional<GoalFault> check_transfer(const Goal& goal);
std::optional<GoalFault> objects_suit(const Goal& goal, const Scene& scene);

std::unique_ptr<GoalTracker> track_framing(const Goal& goal, const GoalWatch& watch);
std::unique_ptr<GoalTracker> track_tip(const Goal& goal, const GoalWatch& watch);
std::optional<GoalFault> check_framing(const Goal& goal);
std::optional<GoalFault> camera_targets_suit(const Goal& goal, const Scene& scene);

inline constexpr GoalKey centre = {"centre_deg",
                                   QT_TRANSLATE_NOOP("errors", "degrees from the middle of the image")};
inline constexpr GoalKey horizon = {
    "horizon_deg", QT_TRANSLATE_NOOP("errors", "degrees between the image's upright and the body's")};
inline constexpr GoalKey size = {"size_share",
                                 QT_TRANSLATE_NOOP("errors", "how far the size may be off the wanted one")};
inline constexpr GoalKey traction_low = {
    "traction_low_n_m", QT_TRANSLATE_NOOP("errors", "the least traction across the line, N/m")};
inline constexpr GoalKey traction_high = {
    "traction_high_n_m", QT_TRANSLATE_NOOP("errors", "the most traction across the line, N/m")};

}  // namespace goals

inline constexpr GoalType goal_types[] = {
    {GoalKind::touch_targets,
     "touch_targets",
     QT_TRANSLATE_NOOP("fulcrum::goals", "Touch targets"),
     GoalSite::targets,
     GoalMeasure::count,
     false,
     {{{"hand", QT_TRANSLATE_NOOP("errors", "left or right")},
       {"count", QT_TRANSLATE_NOOP("errors", "how many spheres")},
       {"hold_s", QT_TRANSLATE_NOOP("errors", "seconds to hold each")}}},
     nullptr,
     goals::targets_suit,
     goals::track_targets},
    {GoalKind::run_bowel,
     "run_bowel",
     QT_TRANSLATE_NOOP("fulcrum::goals", "Run the bowel"),
     GoalSite::bowel,
     GoalMeasure::metres,
     false,
     {{{"length_m", QT_TRANSLATE_NOOP("errors", "metres of bowel to run")},
       {"from_m", QT_TRANSLATE_NOOP("errors", "where to start")},
       {"to_m", QT_TRANSLATE_NOOP("errors", "where the run leads")},
       {"minimum_step_m", QT_TRANSLATE_NOOP("errors", "shortest step that counts")},
       {"maximum_step_m", QT_TRANSLATE_NOOP("errors", "longest step that counts")}}},
     goals::check_run,
     goals::on_bowel,
     goals::track_run},
    {GoalKind::lift_and_hold,
     "lift_and_hold",
     QT_TRANSLATE_NOOP("fulcrum::goals", "Lift and hold"),
     GoalSite::bowel,
     GoalMeasure::seconds,
     false,
     {{{"hold_s", QT_TRANSLATE_NOOP("errors", "seconds to hold")},
       {"from_m", QT_TRANSLATE_NOOP("errors", "where the stretch begins")},
       {"to_m", QT_TRANSLATE_NOOP("errors", "where the stretch ends")},
       {"height_m", QT_TRANSLATE_NOOP("errors", "metres above the resting height")}}},
     goals::check_stretch,
     goals::on_bowel,
     goals::track_lift},
    {GoalKind::take_tension,
     "take_tension",
     QT_TRANSLATE_NOOP("fulcrum::goals", "Take tension"),
     GoalSite::sheet,
     GoalMeasure::seconds,
     true,
     {{{"hold_s", QT_TRANSLATE_NOOP("errors", "seconds to keep the traction")},
       goals::traction_low,
       goals::traction_high}},
     goals::check_traction,
     goals::line_suits,
     goals::track_tension},
    {GoalKind::divide_line,
     "divide_line",
     QT_TRANSLATE_NOOP("fulcrum::goals", "Divide the line"),
     GoalSite::sheet,
     GoalMeasure::metres,
     true,
     {{{"length_m", QT_TRANSLATE_NOOP("errors", "metres of the marked line")},
       {"tolerance_m", QT_TRANSLATE_NOOP("errors", "metres from the line that are too far")},
       {"corridor_m", QT_TRANSLATE_NOOP("errors", "metres from the line within which a cut divides it")},
       goals::traction_low,
       goals::traction_high}},
     goals::check_line,
     goals::line_suits,
     goals::track_line},
    {GoalKind::let_go,
     "let_go",
     QT_TRANSLATE_NOOP("fulcrum::goals", "Let go"),
     GoalSite::sheet,
     GoalMeasure::seconds,
     false,
     {{{"hold_s", QT_TRANSLATE_NOOP("errors", "seconds without a hold")}}},
     nullptr,
     goals::line_suits,
     goals::track_let_go},
    {GoalKind::divide_bands,
     "divide_bands",
     QT_TRANSLATE_NOOP("fulcrum::goals", "Divide bands"),
     GoalSite::bands,
     GoalMeasure::count,
     false,
     {{{"count", QT_TRANSLATE_NOOP("errors", "how many bands")}}},
     nullptr,
     goals::enough_bands,
     goals::track_bands},
    {GoalKind::stop_bleeding,
     "stop_bleeding",
     QT_TRANSLATE_NOOP("fulcrum::goals", "Stop the bleeding"),
     GoalSite::bands,
     GoalMeasure::count,
     false,
     {{{"count", QT_TRANSLATE_NOOP("errors", "how many vessels")},
       {"hold_s", QT_TRANSLATE_NOOP("errors", "seconds without bleeding")}}},
     nullptr,
     goals::enough_vessels,
     goals::track_bleeding},
    {GoalKind::palpate,
     "palpate",
     QT_TRANSLATE_NOOP("fulcrum::goals", "Palpate the bowel"),
     GoalSite::bowel,
     GoalMeasure::seconds,
     false,
     {{{"hand", QT_TRANSLATE_NOOP("errors", "left or right")},
       {"hold_s", QT_TRANSLATE_NOOP("errors", "seconds of contact")},
       {"from_m", QT_TRANSLATE_NOOP("errors", "where the stretch begins")},
       {"to_m", QT_TRANSLATE_NOOP("errors", "where the stretch ends")}}},
     goals::check_stretch,
     goals::on_bowel,
     goals::track_palpation},
    {GoalKind::transfer_objects,
     "transfer_objects",
     QT_TRANSLATE_NOOP("fulcrum::goals", "Transfer objects"),
     GoalSite::objects,
     GoalMeasure::count,
     false,
     {{{"hand", QT_TRANSLATE_NOOP("errors", "the hand that lifts each ring: left or right")},
       {"count", QT_TRANSLATE_NOOP("errors", "how many rings")},
       {"hold_s", QT_TRANSLATE_NOOP("errors", "seconds that both hands hold a ring in the air")},
       {"height_m",
        QT_TRANSLATE_NOOP("errors", "metres above the tray from where on a ring is in the air")}}},
     goals::check_transfer,
     goals::objects_suit,
     goals::track_transfer},
    {GoalKind::frame_targets,
     "frame_targets",
     QT_TRANSLATE_NOOP("fulcrum::goals", "Frame targets"),
     GoalSite::camera_targets,
     GoalMeasure::count,
     false,
     {{{"count", QT_TRANSLATE_NOOP("errors", "how many targets")},
       {"hold_s", QT_TRANSLATE_NOOP("errors", "seconds to keep each framed")},
       goals::centre,
       goals::horizon,
       goals::size}},
     goals::check_framing,
     goals::camera_targets_suit,
     goals::track_framing},
    {GoalKind::follow_tip,
     "follow_tip",
     QT_TRANSLATE_NOOP("fulcrum::goals", "Follow the tip"),
     GoalSite::camera_targets,
     GoalMeasure::seconds,
     false,
     {{{"hold_s", QT_TRANSLATE_NOOP("errors", "seconds in all that the tip is framed")},
       goals::centre,
       goals::horizon,
       goals::size}},
     goals::check_framing,
     nullptr,
     goals::track_tip},
};
static_assert(in_order(goal_types));

constexpr const GoalType& type_of(GoalKind kind) {
    return row_of(goal_types, kind);
}

/// Whether the scene has a goal's site and what the goal needs there.
std::optional<GoalFault> goal_fault(const Goal& goal, const Scene& scene);

}  // namespace fulcrum
