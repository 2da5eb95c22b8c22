// SPDX-License-Identifier: GPL-3.0-or-later
// Everything the debrief shows of one attempt, read and prepared off the UI thread from the stored record:
// nothing is simulated again, and no value is computed here that the score does not hold.
#pragma once

#include <QString>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assessment/task/task.h"
#include "database/records/attempts.h"
#include "database/records/report_data.h"
#include "sim_core/scene/scene.h"
#include "ui/charts/decimation.h"
#include "ui/review/attempt_course.h"
#include "ui/services/application_services.h"

namespace fulcrum::ui {

inline constexpr std::size_t speed_raster = 10, speed_window = 40;  // samples

struct PathPoint {
    double time = 0;                     ///< s
    Vector3 position = Vector3::Zero();  ///< m, patient frame
};

/// A line of the event list.
struct EventLine {
    double time = 0;
    Event event;
    QString words;
    bool severe = false;  ///< a penalty: over-force, perforation, tear, drop, slip
    bool critical = false;
};

struct AttemptModel {
    database::AttemptSummary summary;
    std::optional<database::ScoreRow> score;       ///< in force
    std::optional<database::ScoreRow> recomputed;  ///< the newest, next to it
    std::optional<PathologyReport> pathology;      ///< of the score in force, where there is a specimen
    std::shared_ptr<const database::Trace> trace;  ///< null until the whole record was read, for the replay
    std::size_t samples = 0;                       ///< recorded
    double begin = 0;     ///< s, of the record: of practice from a moment that moment
    double duration = 0;  ///< s: when the record ends
    std::array<std::shared_ptr<const MinMaxPyramid>, hand_count> force;  ///< N over s
    /// mm/s over s, every 10 samples; the mean over speed_window samples.
    std::array<std::shared_ptr<const MinMaxPyramid>, hand_count> speed;
    TractionCourse traction;                                ///< while tissue was divided
    std::array<std::vector<ChartSpan>, hand_count> energy;  ///< when it was on
    std::shared_ptr<const MinMaxPyramid> heat;              ///< mm2 over s; null where nothing was recorded
    std::array<std::vector<PathPoint>, hand_count> path;    ///< at most 4,000 points each
    std::vector<EventLine> events;                          ///< those worth a line, by time
    std::vector<int> goals_done;                            ///< indices of the task's goals, as they ended
    std::vector<std::pair<std::string, double>> force_limits;  ///< tissue label, N
    std::vector<std::string> tissues;
    double tick = 1e-3;        ///< s
    bool scope_alone = false;  ///< the scope was the only instrument
};

/// Reads and prepares all but the trace: an hour's charts are ready within a second. Worker thread. Empty
/// when stopped. Throws AccessDenied, StoreError.
std::optional<AttemptModel> load_attempt(const database::Store& store, const database::Session& session,
                                         const std::string& attempt_id, const std::optional<Scene>& scene,
                                         const Progress& progress);

/// The score in force, the newest recomputed one and the specimen: known also without a recording. Throws
/// AccessDenied, StoreError.
void take_scores(const database::Attempts& attempts, const database::Session& session, AttemptModel& model);

/// The same of a trace that is in memory, with it. `summary` and `score`: of that attempt.
AttemptModel model_of_trace(database::AttemptSummary summary, std::optional<database::ScoreRow> score,
                            std::shared_ptr<const database::Trace> trace, const std::optional<Scene>& scene);

/// Keeps points at least `spacing` m from the one kept before, then doubles the spacing until at most `limit`
/// are left.
std::vector<PathPoint> thin_path(std::vector<PathPoint> points, double spacing, std::size_t limit);

/// In place of replay, charts and events where summary.meta.keep_trace is false.
QString trace_not_kept_text();
/// The same of an attempt that was recorded elsewhere.
QString external_trace_text(const std::string& source);

/// What the attempt produced, in a sentence: the steps done, and those left; of practice from a moment those
/// from the step on that it begins in. Empty for a task without steps.
QString product_text(const AttemptModel& model, const TaskDefinition& task);

/// The speed of a tip that was sampled at `time` (s, rising); where it was not inside the body, or samples
/// are missing, there is no value (NaN). mm/s. `begins`: rising, the samples with a gap before them, across
/// which nothing is measured.
std::vector<float> tip_speed(const std::vector<double>& time, const std::vector<Vector3>& tip,
                             const std::vector<bool>& inside, const std::vector<std::size_t>& begins = {});

/// The four numbers of the debrief. Values as in the score; absent ones say why in `why`.
struct Headline {
    QString title, value, why;
    std::string metric;  ///< id of the metric that explains it
};
std::array<Headline, 4> headlines(const AttemptModel& model);

/// The row of a metric, null where there is none.
const database::MetricRow* find_metric_row(const database::ScoreRow& score, const std::string& id,
                                           const std::string& hand, const std::string& tissue = {});

}  // namespace fulcrum::ui
