// SPDX-License-Identifier: Apache-2.0
#include "assessment/metrics/analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "assessment/metrics/signal.h"

namespace fulcrum {

namespace {

constexpr double motion_cutoff = 10.0;  // Hz
// Higher frequencies are noise of the device. Physiological tremor (6 to 12 Hz, harmonics up to 25 Hz)
// belongs to the hand; a low-pass at 10 Hz would count half of it as noise of the device.
constexpr double noise_cutoff = 50.0;  // Hz
constexpr std::size_t decimation = 10;
constexpr double shortest_segment_s = 0.3, longest_segment_s = 10.0, slowest_peak = 0.020;
constexpr double valley_share = 0.5;     // of the lower of the peaks on both sides
constexpr double shortest_free_s = 0.2;  // between two contacts
static_assert(decimation * 100 == 1000);

/// Three columns of the same length as points.
Eigen::Matrix3Xd points_of(const std::vector<double>& x, const std::vector<double>& y,
                           const std::vector<double>& z) {
    Eigen::Matrix3Xd out(3, static_cast<Eigen::Index>(x.size()));
    for (std::size_t i = 0; i < x.size(); ++i) out.col(static_cast<Eigen::Index>(i)) << x[i], y[i], z[i];
    return out;
}

/// The block's own samples, without the held ends of the decimated columns.
Eigen::Matrix3Xd between_rests(const Eigen::Matrix3Xd& points, std::size_t size, const Vector3& before,
                               const Vector3& after) {
    Eigen::Matrix3Xd out(3, static_cast<Eigen::Index>(size + 2));
    const auto hold = static_cast<Eigen::Index>(hold_samples(motion_rate));
    out.col(0) = before;
    out.middleCols(1, static_cast<Eigen::Index>(size)) =
        points.middleCols(hold, static_cast<Eigen::Index>(size));
    out.col(out.cols() - 1) = after;
    return out;
}

template <typename T>
std::vector<T> decimate(const std::vector<T>& column) {
    std::vector<T> out;
    out.reserve(column.size() / decimation + 1);
    for (std::size_t i = 0; i < column.size(); i += decimation) out.push_back(column[i]);
    return out;
}

/// Sums of position minus its low-pass, one entry for each sample at 100 Hz (ten samples at 1 kHz).
struct Residuals {
    std::vector<double> sum, square, count;
};

Residuals residuals_of(const std::vector<double>& raw, const std::vector<double>& smooth) {
    Residuals out;
    const std::size_t cells = (raw.size() - 1) / decimation + 1;
    out.sum.assign(cells, 0);
    out.square.assign(cells, 0);
    out.count.assign(cells, 0);
    for (std::size_t i = 0; i < raw.size(); ++i) {
        const double residual = raw[i] - smooth[i];
        out.sum[i / decimation] += residual;
        out.square[i / decimation] += residual * residual;
        out.count[i / decimation] += 1;
    }
    return out;
}

/// Accumulates a standard deviation over pauses, for one component.
struct Deviation {
    double sum = 0, square = 0, count = 0;
    void add(const Residuals& residuals, const std::vector<std::uint8_t>& pause) {
        for (std::size_t i = 0; i < pause.size(); ++i) {
            if (pause[i] == 0) continue;
            sum += residuals.sum[i];
            square += residuals.square[i];
            count += residuals.count[i];
        }
    }
    double value() const { return std::sqrt(std::max(0.0, square / count - (sum / count) * (sum / count))); }
};

/// Speeds by central differences; the held ends give the first and last sample their neighbours.
template <typename Distance>
std::vector<double> rates_of(const Eigen::Matrix3Xd& points, std::size_t size, Distance distance) {
    std::vector<double> out(size);
    for (std::size_t i = 0; i < size; ++i) {
        const auto k = static_cast<Eigen::Index>(i + hold_samples(motion_rate));
        out[i] = distance(points.col(k - 1), points.col(k + 1)) * motion_rate / 2.0;
    }
    return out;
}

}  // namespace

UniformGrid::UniformGrid(const std::vector<double>& t, const TraceBlock& block)
    : begin_(t[block.first]), first_(block.first) {
    const double duration = t[block.last - 1] - begin_;
    size_ = static_cast<std::size_t>(std::floor(duration * force_rate + 1e-6)) + 1;
    bool same = size_ == block.last - block.first;
    for (std::size_t i = 0; same && i < size_; ++i)
        same = std::abs(t[first_ + i] - begin_ - static_cast<double>(i) / force_rate) < 1e-7;
    if (same) return;
    index_.resize(size_);
    fraction_.resize(size_);
    std::size_t k = block.first;
    for (std::size_t i = 0; i < size_; ++i) {
        const double time = begin_ + static_cast<double>(i) / force_rate;
        while (k + 1 < block.last && t[k + 1] <= time + 1e-9) ++k;
        index_[i] = k;
        fraction_[i] = k + 1 < block.last ? std::clamp((time - t[k]) / (t[k + 1] - t[k]), 0.0, 1.0) : 0.0;
    }
}

std::vector<double> UniformGrid::interpolate(const std::vector<double>& column) const {
    if (index_.empty()) return hold(column);
    std::vector<double> out(size_);
    for (std::size_t i = 0; i < size_; ++i) {
        const std::size_t k = index_[i];
        out[i] = fraction_[i] > 0 ? column[k] + fraction_[i] * (column[k + 1] - column[k]) : column[k];
    }
    return out;
}

std::vector<double> UniformGrid::interpolate_within(const std::vector<double>& column,
                                                    const std::vector<std::int16_t>& label) const {
    if (index_.empty() || label.empty()) return interpolate(column);
    std::vector<double> out(size_);
    for (std::size_t i = 0; i < size_; ++i) {
        const std::size_t k = index_[i];
        const bool between = fraction_[i] > 0 && label[k] == label[k + 1];
        out[i] = between ? column[k] + fraction_[i] * (column[k + 1] - column[k]) : column[k];
    }
    return out;
}

std::size_t MotionBlock::index(double t) const {
    const double i = std::clamp((t - begin) * motion_rate, 0.0, static_cast<double>(size() - 1));
    return static_cast<std::size_t>(std::lround(i));
}

std::vector<std::uint8_t> find_pauses(const std::vector<double>& speed) {
    std::vector<std::uint8_t> pause(speed.size(), 0);
    for (const Run& run : runs_of(speed.size(), [&](std::size_t i) { return speed[i] < rest_speed; })) {
        const bool at_end = run.first == 0 || run.last == speed.size();
        if (at_end || static_cast<double>(run.size()) >= rest_time * motion_rate)
            std::fill(pause.begin() + static_cast<std::ptrdiff_t>(run.first),
                      pause.begin() + static_cast<std::ptrdiff_t>(run.last), std::uint8_t{1});
    }
    return pause;
}

std::vector<Segment> find_segments(const std::vector<double>& speed, const std::vector<std::uint8_t>& pause) {
    std::vector<Segment> segments;
    for (const Run& core : runs_of(speed.size(), [&](std::size_t i) { return pause[i] == 0; })) {
        if (core.first == 0 || core.last == speed.size())
            continue;  // cut off by the block, not a whole movement
        Run whole = core;
        while (whole.first > 0 && speed[whole.first - 1] < speed[whole.first]) --whole.first;
        while (whole.last < speed.size() && speed[whole.last] < speed[whole.last - 1]) ++whole.last;
        const double peak = *std::max_element(speed.begin() + static_cast<std::ptrdiff_t>(core.first),
                                              speed.begin() + static_cast<std::ptrdiff_t>(core.last));
        const double duration = static_cast<double>(whole.size()) / motion_rate;
        if (duration >= shortest_segment_s && duration <= longest_segment_s && peak >= slowest_peak)
            segments.push_back({0, core, whole});
    }
    return segments;
}

namespace {

/// Where [first, last) is divided: at the lowest speed relative to the lower of the peaks on both sides.
std::optional<std::size_t> valley(const std::vector<double>& speed, const Run& run) {
    std::vector<double> after(run.size());
    double peak = 0;
    for (std::size_t i = run.size(); i-- > 0;) after[i] = peak = std::max(peak, speed[run.first + i]);
    double before = 0, lowest = valley_share;
    std::optional<std::size_t> at;
    for (std::size_t i = 0; i < run.size(); ++i) {
        const double v = speed[run.first + i];
        before = std::max(before, v);
        const double limit = lowest * std::min(before, after[i]);
        if (v >= limit) continue;
        lowest = v / std::min(before, after[i]);
        at = run.first + i;
    }
    return at;
}

}  // namespace

FreeMovement find_free_movements(const std::vector<double>& speed, const std::vector<std::uint8_t>& pause,
                                 std::vector<std::uint8_t> contact) {
    for (const Run& gap : runs_of(contact.size(), [&](std::size_t i) { return contact[i] == 0; }))
        if (gap.first > 0 && gap.last < contact.size() &&
            static_cast<double>(gap.size()) < shortest_free_s * motion_rate)
            std::fill(contact.begin() + static_cast<std::ptrdiff_t>(gap.first),
                      contact.begin() + static_cast<std::ptrdiff_t>(gap.last), std::uint8_t{1});
    const auto free = [&](std::size_t i) { return contact.empty() || contact[i] == 0; };
    FreeMovement found;
    std::vector<Run> open = runs_of(speed.size(), [&](std::size_t i) { return pause[i] == 0 && free(i); });
    for (const Run& run : open)
        if (static_cast<double>(run.size()) >= shortest_segment_s * motion_rate) found.samples += run.size();
    std::reverse(open.begin(), open.end());
    while (!open.empty()) {
        const Run core = open.back();
        open.pop_back();
        if (const auto at = valley(speed, core)) {
            open.push_back({*at, core.last});
            open.push_back({core.first, *at});
            continue;
        }
        if (core.first == 0 || core.last == speed.size()) continue;  // cut off by the block
        Run whole = core;
        while (whole.first > 0 && free(whole.first - 1) && speed[whole.first - 1] < speed[whole.first])
            --whole.first;
        while (whole.last < speed.size() && free(whole.last) && speed[whole.last] < speed[whole.last - 1])
            ++whole.last;
        const double peak = *std::max_element(speed.begin() + static_cast<std::ptrdiff_t>(core.first),
                                              speed.begin() + static_cast<std::ptrdiff_t>(core.last));
        const double duration = static_cast<double>(whole.size()) / motion_rate;
        if (duration >= shortest_segment_s && duration <= longest_segment_s && peak >= slowest_peak)
            found.segments.push_back({0, core, whole});
    }
    return found;
}

Analysis::Analysis(const Trace& trace, const std::vector<Event>& events, const MetricContext& context)
    : trace_(trace),
      events_(events),
      context_(context),
      tissues_(trace.tissues),
      mean_rate_(trace.mean_rate()) {
    for (const TissueLimits& tissue : context.tissues)
        if (std::find(tissues_.begin(), tissues_.end(), tissue.label) == tissues_.end())
            tissues_.push_back(tissue.label);
    for (const TraceBlock& block : trace.blocks)
        if (block.last - block.first >= 2) grids_.emplace_back(trace.t, block);
    for (std::size_t h = 0; h < hands_.size(); ++h) {
        hands_[h] = motion_of(trace.hand[h]);
        hands_[h].touched.assign(tissues_.size(), 0);
        for (const std::int16_t tissue : trace.hand[h].tissue)
            if (tissue >= 0 && static_cast<std::size_t>(tissue) < tissues_.size())
                hands_[h].touched[static_cast<std::size_t>(tissue)] = 1;
        build_force(h);
    }
}

namespace {

/// 1 at 100 Hz where a blade is in tissue or the jaws hold it; empty where the trace does not show it.
std::vector<std::uint8_t> contact_of(const HandTrace& hand, const UniformGrid& grid, std::size_t size) {
    std::vector<std::uint8_t> contact;
    if (hand.has(Channel::cutting)) contact = decimate(grid.hold(hand.cutting));
    if (!hand.has(Channel::jaw_force)) return contact;
    contact.resize(size);
    const std::vector<double> jaw = decimate(grid.hold(hand.jaw_force));
    std::vector<std::int16_t> tissue;
    if (hand.has(Channel::tissue)) tissue = decimate(grid.hold(hand.tissue));
    for (std::size_t i = 0; i < size; ++i)
        if (jaw[i] > contact_force && (tissue.empty() || tissue[i] >= 0)) contact[i] = 1;
    return contact;
}

}  // namespace

const HandAnalysis& Analysis::scope() const {
    if (!scope_) {
        HandTrace lens;
        lens.px = trace_.camera.px;
        lens.py = trace_.camera.py;
        lens.pz = trace_.camera.pz;
        scope_ = motion_of(lens);
    }
    return *scope_;
}

HandAnalysis Analysis::motion_of(const HandTrace& hand) const {
    HandAnalysis out;
    if (!hand.has(Channel::position)) return out;
    std::array<Deviation, 3> noise;
    for (const UniformGrid& grid : grids_) {
        MotionBlock block;
        block.begin = grid.begin();
        const std::size_t size = (grid.size() - 1) / decimation + 1;
        std::array<std::vector<double>, 3> smooth;
        std::array<Residuals, 3> residuals;
        const std::array<const std::vector<double>*, 3> columns = {&hand.px, &hand.py, &hand.pz};
        Vector3 first, last;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::vector<double> raw = grid.interpolate(*columns[c]);
            first[static_cast<Eigen::Index>(c)] = raw.front();
            last[static_cast<Eigen::Index>(c)] = raw.back();
            smooth[c] = decimate(low_pass_held(raw, motion_cutoff, force_rate));
            residuals[c] = residuals_of(raw, low_pass(raw, noise_cutoff, force_rate));
        }
        const Eigen::Matrix3Xd position = points_of(smooth[0], smooth[1], smooth[2]);
        block.position = between_rests(position, size, first, last);
        block.speed =
            rates_of(position, size, [](const Vector3& a, const Vector3& b) { return (b - a).norm(); });
        if (hand.has(Channel::axis)) {
            const auto filtered = [&](const std::vector<double>& column) {
                return decimate(low_pass_held(grid.interpolate(column), motion_cutoff, force_rate));
            };
            Eigen::Matrix3Xd axis = points_of(filtered(hand.ax), filtered(hand.ay), filtered(hand.az));
            axis.colwise().normalize();
            block.axis = between_rests(axis, size, axis.col(0), axis.col(axis.cols() - 1));
            block.angular_speed =
                rates_of(axis, size, [](const Vector3& a, const Vector3& b) { return angle_between(a, b); });
        }
        block.active =
            hand.has(Channel::inside) ? decimate(grid.hold(hand.inside)) : std::vector<std::uint8_t>(size, 1);
        if (hand.has(Channel::in_view)) block.in_view = decimate(grid.hold(hand.in_view));
        if (hand.has(Channel::tissue)) block.tissue = decimate(grid.hold(hand.tissue));
        block.pause = find_pauses(block.speed);
        for (Segment& segment : find_segments(block.speed, block.pause)) {
            segment.block = out.motion.size();
            out.segments.push_back(segment);
        }
        FreeMovement movement = find_free_movements(block.speed, block.pause, contact_of(hand, grid, size));
        for (Segment& segment : movement.segments) {
            segment.block = out.motion.size();
            out.free_segments.push_back(segment);
        }
        out.free_moving_samples += movement.samples;
        out.moving_samples += static_cast<std::size_t>(std::count(block.pause.begin(), block.pause.end(), 0));
        for (std::size_t c = 0; c < 3; ++c) noise[c].add(residuals[c], block.pause);
        out.motion.push_back(std::move(block));
    }
    if (noise[0].count > 0)
        out.noise_at_rest = std::max({noise[0].value(), noise[1].value(), noise[2].value()});
    return out;
}

std::optional<double> Analysis::force_limit(int tissue) const {
    if (tissue < 0) return std::nullopt;
    for (const TissueLimits& limits : context_.tissues)
        if (limits.label == tissues_[static_cast<std::size_t>(tissue)]) return limits.force;
    return std::nullopt;
}

bool Analysis::any_force_limit() const {
    return std::any_of(context_.tissues.begin(), context_.tissues.end(),
                       [](const TissueLimits& limits) { return limits.force.has_value(); });
}

std::optional<std::size_t> Analysis::block_at(int h, double t) const {
    const auto& blocks = hand(h).motion;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        if (t >= blocks[b].begin - 0.005 && t <= blocks[b].time(blocks[b].size() - 1) + 0.015) return b;
    return std::nullopt;
}

std::optional<double> Analysis::first_movement(int h) const {
    for (const MotionBlock& block : hand(h).motion)
        for (const Run& run : runs_of(block.size(), [&](std::size_t i) {
                 return block.speed[i] > rest_speed && block.active[i] != 0;
             }))
            if (static_cast<double>(run.size()) >= rest_time * motion_rate) return block.time(run.first);
    return std::nullopt;
}

double begin_of(const Analysis& analysis) {
    for (const Event& event : analysis.events())
        if (event.kind == EventKind::first_movement) return analysis.trace().time_of(event);
    return -std::numeric_limits<double>::infinity();
}

double running_time(const Trace& trace, double begin, double end) {
    double time = std::max(0.0, end - begin);
    for (const TimeInterval& pause : trace.pauses)
        time -= std::max(0.0, std::min(end, pause.end) - std::max(begin, pause.begin));
    return std::max(0.0, time);
}

std::vector<TimeInterval> worst_first(std::vector<ScoredInterval> intervals) {
    std::stable_sort(intervals.begin(), intervals.end(),
                     [](const ScoredInterval& a, const ScoredInterval& b) { return a.score > b.score; });
    if (intervals.size() > evidence_limit) intervals.resize(evidence_limit);
    std::vector<TimeInterval> out;
    for (const ScoredInterval& scored : intervals) out.push_back(scored.interval);
    return out;
}

Figure absent(Absence absence, Statement because) {
    Figure figure;
    figure.absence = absence;
    figure.because = std::move(because);
    return figure;
}

Figure value_of(double value, std::vector<TimeInterval> evidence) {
    Figure figure;
    figure.value = value;
    figure.evidence = std::move(evidence);
    return figure;
}

Figure count_events(const Analysis& analysis, const Selection& row, EventKind kind) {
    int count = 0;
    Figure figure;
    for (const Event& event : analysis.events()) {
        if (event.kind != kind) continue;
        if (row.hand >= 0 && event.hand != row.hand) continue;
        if (row.tissue >= 0 && event.tissue != row.tissue) continue;
        ++count;
        const double t = analysis.trace().time_of(event);
        if (figure.evidence.size() < evidence_limit)
            figure.evidence.push_back({std::max(0.0, t - 0.5), t + 0.5});
    }
    figure.value = count;
    return figure;
}

void worst_window(const MotionBlock& block, const std::vector<double>& amount,
                  std::vector<ScoredInterval>& out) {
    const std::size_t width = std::min<std::size_t>(500, amount.size());
    if (width == 0) return;
    double sum = 0, best = -1;
    std::size_t best_end = width;
    for (std::size_t i = 0; i < amount.size(); ++i) {
        sum += amount[i];
        if (i >= width) sum -= amount[i - width];
        if (i + 1 >= width && sum > best) {
            best = sum;
            best_end = i + 1;
        }
    }
    out.push_back({best, block.interval({best_end - width, best_end})});
}

}  // namespace fulcrum
