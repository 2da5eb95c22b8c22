// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/attempt_model.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>

#include "ui/review/event_words.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

constexpr double fibres_line_s = 1;

struct HeadlineTexts {
    Q_DECLARE_TR_FUNCTIONS(fulcrum::ui::HeadlineTexts)
};

}  // namespace

std::vector<PathPoint> thin_path(std::vector<PathPoint> points, double spacing, std::size_t limit) {
    while (true) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool last = i + 1 == points.size();
            if (kept == 0 || last || (points[i].position - points[kept - 1].position).norm() >= spacing) {
                points[kept++] = points[i];
            }
        }
        points.resize(kept);
        if (kept <= limit) return points;
        spacing *= 1.6;
    }
}

std::vector<float> tip_speed(const std::vector<double>& time, const std::vector<Vector3>& tip,
                             const std::vector<bool>& inside, const std::vector<std::size_t>& begins) {
    constexpr std::size_t half = speed_window / speed_raster / 2;
    constexpr double to_mm = 1e3, longest = 2;  // of a gap, in windows without a lost sample
    std::vector<float> speed(time.size(), std::numeric_limits<float>::quiet_NaN());
    std::size_t piece = 0;  // where the present one begins
    auto next = begins.begin();
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (next != begins.end() && *next == i) {
            piece = i;
            ++next;
        }
        const std::size_t piece_end = next == begins.end() ? time.size() : *next;
        const std::size_t first = i < piece + half ? piece : i - half,
                          last = std::min(i + half, piece_end - 1);
        const double span = time[last] - time[first];
        const double usual = time.size() < 2 ? 0 : time[1] - time[0];
        if (!(span > 0) || span > longest * 2 * half * usual) continue;
        if (!inside[first] || !inside[i] || !inside[last]) continue;
        speed[i] = static_cast<float>(to_mm * (tip[last] - tip[first]).norm() / span);
    }
    return speed;
}

namespace {

/// One chunk's part of the charts.
struct ChunkPart {
    std::vector<double> time;
    std::array<std::vector<float>, hand_count> force;
    std::array<std::vector<ChartSpan>, hand_count> energy;
    std::array<std::vector<PathPoint>, hand_count> path;
    std::vector<double> raster;  ///< s, of every speed_raster-th sample
    std::array<std::vector<Vector3>, hand_count> tip;
    std::array<std::vector<bool>, hand_count> inside;
};

double signed_count(std::uint32_t column) {
    return static_cast<std::int32_t>(column);
}

ChunkPart part_of(const database::TraceOverview& overview, double tick) {
    ChunkPart part;
    const std::size_t count = overview.tick.size();
    part.time.resize(count);
    for (std::size_t i = 0; i < count; ++i) part.time[i] = overview.tick[i] * tick;
    for (std::size_t i = 0; i < count; i += speed_raster) part.raster.push_back(part.time[i]);
    for (std::size_t h = 0; h < hand_count; ++h) {
        const database::TraceOverview::Hand& hand = overview.hand[h];
        part.force[h].resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const double fx = signed_count(hand.force[0][i]), fy = signed_count(hand.force[1][i]),
                         fz = signed_count(hand.force[2][i]);
            part.force[h][i] = static_cast<float>(std::sqrt(fx * fx + fy * fy + fz * fz) * sample_force_unit);
        }
        part.energy[h] = spans_of_flag(part.time, hand.flags, hand_energy, tick);
        std::vector<PathPoint>& path = part.path[h];
        for (std::size_t i = 0; i < count; ++i) {
            const bool inside = (hand.flags[i] & hand_inside) != 0, on_raster = i % speed_raster == 0;
            if (!inside && !on_raster) continue;
            const Vector3 tip = Vector3(signed_count(hand.tip[0][i]), signed_count(hand.tip[1][i]),
                                        signed_count(hand.tip[2][i])) *
                                sample_length_unit;
            if (on_raster) {
                part.tip[h].push_back(tip);
                part.inside[h].push_back(inside);
            }
            if (!inside) continue;
            // A tenth of a millimetre is finer than any screen shows.
            if (path.empty() || (tip - path.back().position).squaredNorm() > 1e-8)
                path.push_back({part.time[i], tip});
        }
    }
    return part;
}

/// Which values of a record belong together.
struct Pieces {
    std::vector<std::size_t> begins;  ///< of the values that begin a piece, but for the first
    std::vector<bool> outside;        ///< by value: it belongs to none
};

/// `sample`: of each value the index in the record.
template <typename Sample>
Pieces pieces_of(std::size_t count, const std::vector<TraceBlock>& blocks, const Sample& sample) {
    Pieces pieces;
    pieces.outside.resize(count);
    const std::size_t none = blocks.size();
    std::size_t block = 0, before = none;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = sample(i);
        while (block < blocks.size() && blocks[block].last <= at) ++block;
        pieces.outside[i] = block == blocks.size() || at < blocks[block].first;
        if (pieces.outside[i]) continue;
        if (before != none && before != block) pieces.begins.push_back(i);
        before = block;
    }
    return pieces;
}

/// Every part in its place; both hands at the same time.
void join(const std::vector<ChunkPart>& parts, const std::vector<Event>& events, AttemptModel& model) {
    std::size_t samples = 0;
    for (const ChunkPart& part : parts) samples += part.time.size();
    std::vector<double> time, raster;
    std::vector<std::size_t> on_raster;  // samples
    time.reserve(samples);
    for (const ChunkPart& part : parts) {
        for (std::size_t i = 0; i < part.raster.size(); ++i)
            on_raster.push_back(time.size() + i * speed_raster);
        time.insert(time.end(), part.time.begin(), part.time.end());
        raster.insert(raster.end(), part.raster.begin(), part.raster.end());
    }
    const std::vector<TraceBlock> blocks = joined_samples(time, events, model.tick);
    const Pieces of_samples = pieces_of(samples, blocks, [](std::size_t i) { return i; }),
                 of_raster = pieces_of(raster.size(), blocks, [&](std::size_t i) { return on_raster[i]; });
    const auto join_hand = [&](std::size_t h) {
        std::vector<float> force;
        std::vector<PathPoint> path;
        force.reserve(samples);
        for (const ChunkPart& part : parts) {
            force.insert(force.end(), part.force[h].begin(), part.force[h].end());
            path.insert(path.end(), part.path[h].begin(), part.path[h].end());
            append_spans(model.energy[h], part.energy[h]);
        }
        for (std::size_t i = 0; i < samples; ++i)
            if (of_samples.outside[i]) force[i] = std::numeric_limits<float>::quiet_NaN();
        std::vector<Vector3> tip;
        std::vector<bool> inside;
        for (const ChunkPart& part : parts) {
            tip.insert(tip.end(), part.tip[h].begin(), part.tip[h].end());
            inside.insert(inside.end(), part.inside[h].begin(), part.inside[h].end());
        }
        for (std::size_t i = 0; i < inside.size(); ++i)
            if (of_raster.outside[i]) inside[i] = false;
        std::vector<float> speed = tip_speed(raster, tip, inside, of_raster.begins);
        model.speed[h] = std::make_shared<const MinMaxPyramid>(raster, std::move(speed), of_raster.begins);
        model.force[h] = std::make_shared<const MinMaxPyramid>(time, std::move(force), of_samples.begins);
        model.path[h] = thin_path(std::move(path), 2e-4, chart_point_limit);
    };
    std::thread other([&] { join_hand(1); });
    join_hand(0);
    other.join();
    model.samples = samples;
    model.duration = samples == 0 ? 0 : time.back();
    // Its ticks continue those of what it began with.
    const std::optional<database::AttemptOrigin>& origin = model.summary.meta.origin;
    model.begin = origin ? std::min(origin->tick * model.tick, model.duration) : 0;
}

void take_scene(const Scene& scene, AttemptModel& model) {
    model.tick = scene.tick_period();
    model.scope_alone = scene.instruments.empty();
    for (const TissueSpec& tissue : scene.tissues) {
        model.tissues.push_back(tissue.label);
        if (tissue.force_limit > 0) model.force_limits.emplace_back(tissue.label, tissue.force_limit);
    }
}

void take_events(const std::vector<Event>& events, AttemptModel& model) {
    double parted = -fibres_line_s;
    for (const Event& event : events) {
        if (event.kind == EventKind::phase_end) model.goals_done.push_back(event.detail);
        if (event.kind == EventKind::fibres_parted) {
            // They part bit by bit, many times a second: one line until they have held for a while.
            const double last = std::exchange(parted, event.tick * model.tick);
            if (parted - last < fibres_line_s) continue;
        }
        EventLine line{event.tick * model.tick, event, event_words(event, model.tissues),
                       is_penalty(event.kind), is_critical(event.kind)};
        if (!line.words.isEmpty()) model.events.push_back(std::move(line));
    }
    model.traction = traction_course(events, model.tick, model.duration);
    model.heat = heat_course(events, model.tick, model.duration);
    for (std::vector<ChartSpan>& energy : model.energy)
        energy = without_pauses(energy, events, model.tick, model.duration);
}

/// The columns of samples that are in memory.
database::TraceOverview overview_of(const std::vector<TickSample>& samples) {
    database::TraceOverview overview;
    overview.tick.reserve(samples.size());
    for (const TickSample& sample : samples) {
        overview.tick.push_back(sample.tick);
        for (std::size_t h = 0; h < hand_count; ++h) {
            const HandSample& hand = sample.hand[h];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                overview.hand[h].tip[axis].push_back(static_cast<std::uint32_t>(hand.tip[axis]));
                overview.hand[h].force[axis].push_back(static_cast<std::uint32_t>(hand.force[axis]));
            }
            overview.hand[h].flags.push_back(hand.flags);
        }
    }
    return overview;
}

}  // namespace

AttemptModel model_of_trace(database::AttemptSummary summary, std::optional<database::ScoreRow> score,
                            std::shared_ptr<const database::Trace> trace, const std::optional<Scene>& scene) {
    AttemptModel model;
    model.summary = std::move(summary);
    model.score = std::move(score);
    if (scene) take_scene(*scene, model);
    join({part_of(overview_of(trace->samples), model.tick)}, trace->events, model);
    take_events(trace->events, model);
    model.trace = std::move(trace);
    return model;
}

void take_scores(const database::Attempts& attempts, const database::Session& session, AttemptModel& model) {
    for (database::ScoreRow& score : attempts.scores(session, model.summary.meta.id))
        (score.in_force ? model.score : model.recomputed) = std::move(score);  // the newest comes last
    if (model.score) model.pathology = database::pathology_of(*model.score);
}

std::optional<AttemptModel> load_attempt(const database::Store& store, const database::Session& session,
                                         const std::string& attempt_id, const std::optional<Scene>& scene,
                                         const Progress& progress) {
    AttemptModel model;
    const database::Attempts attempts(store);
    model.summary = attempts.read(session, attempt_id);
    take_scores(attempts, session, model);
    if (scene) take_scene(*scene, model);
    if (progress && !progress(0.1, {})) return std::nullopt;
    std::vector<ChunkPart> parts;
    if (!model.summary.meta.keep_trace) {
        join(parts, {}, model);
        return model;
    }
    attempts.read_overview(
        session, attempt_id, [&](std::size_t chunks) { parts.resize(chunks); },
        [&](std::size_t chunk, const database::TraceOverview& overview) {
            parts[chunk] = part_of(overview, model.tick);
        });
    if (progress && !progress(0.7, {})) return std::nullopt;
    const std::vector<Event> events = attempts.read_events(session, attempt_id);
    join(parts, events, model);
    take_events(events, model);
    if (progress && !progress(1.0, {})) return std::nullopt;
    return model;
}

const database::MetricRow* find_metric_row(const database::ScoreRow& score, const std::string& id,
                                           const std::string& hand, const std::string& tissue) {
    for (const database::MetricRow& row : score.metrics) {
        if (row.id == id && row.hand == hand && row.tissue == tissue) return &row;
    }
    return nullptr;
}

namespace {

/// Of an attempt in which the scope was the only instrument.
std::array<Headline, 4> scope_headlines(const AttemptModel& model) {
    const char* const ids[] = {"time", "scope_path", "horizon_err", "lens_contact"};
    std::array<Headline, 4> shown;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        shown[i] = {metric_text(ids[i]), QStringLiteral("–"), HeadlineTexts::tr("no score"), ids[i]};
        if (!model.score) continue;
        const database::MetricRow* row = find_metric_row(*model.score, ids[i], "");
        shown[i].why = row == nullptr ? HeadlineTexts::tr("not measured") : QString();
        if (row == nullptr) continue;
        if (!row->value) {
            shown[i].why = statement_text(row->absent_because);
        } else {
            shown[i].value = i == 0 ? clock_text(*row->value) : figure_with_unit(*row->value, row->unit);
        }
    }
    return shown;
}

}  // namespace

QString trace_not_kept_text() {
    return HeadlineTexts::tr(
        "The recording of this attempt was not kept, so there is no replay and there are no charts. The "
        "result and the scores are kept.");
}

QString external_trace_text(const std::string& source) {
    return HeadlineTexts::tr(
               "External attempt, recorded by: %1. Its metrics are shown, but there is no scene to replay. "
               "It is not compared with limits and does not count in the curriculum.")
        .arg(text(source));
}

QString product_text(const AttemptModel& model, const TaskDefinition& task) {
    if (task.goals.empty()) return {};
    // Without the events it is known only that all were done.
    if (!model.summary.meta.keep_trace && model.summary.recorded_state != AttemptState::completed) return {};
    const int goals = static_cast<int>(task.goals.size());
    // The steps before the one that practice from a moment begins in were done in what it began with.
    const std::optional<database::AttemptOrigin>& origin = model.summary.meta.origin;
    const int first = origin ? std::clamp(origin->goal, 0, goals - 1) : 0;
    QStringList left;
    for (int i = first; i < goals; ++i) {
        const auto& done = model.goals_done;
        if (std::find(done.begin(), done.end(), i) == done.end())
            left << asset_text(task.goals[static_cast<std::size_t>(i)].text);
    }
    if (left.isEmpty() || model.summary.state == AttemptState::completed)
        return HeadlineTexts::tr("All %1 steps done.").arg(goals);
    return HeadlineTexts::tr("%1 of %2 steps done. Left: %3.")
        .arg(goals - first - left.size())
        .arg(goals - first)
        .arg(left.join(QStringLiteral("; ")));
}

std::array<Headline, 4> headlines(const AttemptModel& model) {
    if (model.scope_alone) return scope_headlines(model);
    std::array<Headline, 4> shown{
        Headline{HeadlineTexts::tr("Time"), QStringLiteral("–"), {}, "time"},
        Headline{HeadlineTexts::tr("Left hand path"), QStringLiteral("–"), {}, "path_len"},
        Headline{HeadlineTexts::tr("Right hand path"), QStringLiteral("–"), {}, "path_len"},
        Headline{HeadlineTexts::tr("Damage"), QStringLiteral("–"), {}, "over_impulse"}};
    const QString no_score = HeadlineTexts::tr("no score");
    for (Headline& headline : shown) headline.why = no_score;
    if (!model.score) return shown;
    const database::ScoreRow& score = *model.score;
    const auto fill = [](Headline& headline, const database::MetricRow* row, const QString& formatted) {
        if (row == nullptr) {
            headline.why = HeadlineTexts::tr("not measured");
        } else if (row->value) {
            headline.value = formatted;
            headline.why.clear();
        } else {
            headline.why = statement_text(row->absent_because);
        }
    };
    const database::MetricRow* time = find_metric_row(score, "time", "");
    fill(shown[0], time, time != nullptr && time->value ? clock_text(*time->value) : QString());
    const char* hands[] = {"left", "right"};
    for (std::size_t h = 0; h < 2; ++h) {
        const database::MetricRow* path = find_metric_row(score, "path_len", hands[h]);
        fill(shown[h + 1], path,
             path != nullptr && path->value ? figure_with_unit(*path->value, path->unit) : QString());
    }
    // Damage: what went over the tissues' limits, both hands together; critical errors below.
    std::optional<double> over;
    std::string unit;
    for (const char* hand : hands) {
        const database::MetricRow* row = find_metric_row(score, "over_impulse", hand);
        if (row == nullptr || !row->value) continue;
        over = over.value_or(0) + *row->value;
        unit = row->unit;
    }
    if (over) {
        shown[3].value = figure_with_unit(over, unit);
        shown[3].why = HeadlineTexts::tr("force over the tissue's limit × time");
    } else {
        shown[3].why = HeadlineTexts::tr("not measured");
    }
    if (!score.critical_errors.empty()) {
        QStringList names;
        for (const database::CriticalErrorRow& error : score.critical_errors) {
            names << event_text(error.kind);
        }
        names.removeDuplicates();
        shown[3].why = HeadlineTexts::tr("critical: %1").arg(names.join(QStringLiteral(", ")));
    }
    return shown;
}

}  // namespace fulcrum::ui
