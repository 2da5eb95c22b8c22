// SPDX-License-Identifier: Apache-2.0
// Jaw forces on tissue, and counted events. A grasp lasts while the jaws press on tissue with more than 0.1
// N.
#include <algorithm>
#include <map>

#include "assessment/metrics/analysis.h"
#include "assessment/metrics/descriptor_text.h"
#include "assessment/metrics/registry.h"

namespace fulcrum {

namespace {

Figure no_grasp() {
    return absent(Absence::not_done, StatementId::nothing_grasped);
}

bool grasping(const ForceBlock& block, std::size_t i, const Selection& row) {
    return block.grasp[i] != 0 && block.on(i, row.tissue);
}

/// Largest entry of a series over the row's grasps.
Figure largest_in_grasps(const Analysis& analysis, const Selection& row,
                         std::vector<double> ForceBlock::*series, double unit) {
    double largest = 0;
    TimeInterval where;
    for (const ForceBlock& block : analysis.hand(row.hand).force) {
        const std::vector<double>& values = block.*series;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!grasping(block, i, row) || values[i] <= largest) continue;
            largest = values[i];
            where = {block.time(i < 250 ? 0 : i - 250), block.time(std::min(i + 250, values.size() - 1))};
        }
    }
    if (!(largest > 0)) return no_grasp();
    Figure figure;
    figure.value = largest * unit;
    figure.evidence = {where};
    return figure;
}

Figure grasp_max(const Analysis& analysis, const Selection& row) {
    return largest_in_grasps(analysis, row, &ForceBlock::jaw, 1.0);
}

Figure grasp_kpa(const Analysis& analysis, const Selection& row) {
    return largest_in_grasps(analysis, row, &ForceBlock::pressure, 1e-3);
}

/// Whether a pause, and no gap, divides two blocks of which one ends and the next begins at these times.
bool only_paused(const Trace& trace, double end, double begin) {
    constexpr double gap = 0.1, slack = 1e-9;  // s, as split_blocks()
    const double running = running_time(trace, end, begin);
    return running <= gap && running < begin - end - slack;
}

/// The row's grasps: jaw force over time, N s, by falling product. Jaws that are closed before and after a
/// pause were closed in it: that is one grasp.
std::vector<ScoredInterval> grasps_of(const Analysis& analysis, const Selection& row) {
    std::vector<ScoredInterval> grasps;
    bool held = false;  // the block before ended in the last of the grasps
    for (const ForceBlock& block : analysis.hand(row.hand).force) {
        const bool held_on = held && only_paused(analysis.trace(), grasps.back().interval.end, block.time(0));
        held = false;
        for (const Run& run :
             runs_of(block.jaw.size(), [&](std::size_t i) { return grasping(block, i, row); })) {
            double product = 0;
            for (std::size_t i = run.first; i < run.last; ++i) product += block.jaw[i] / force_rate;
            if (held_on && run.first == 0) {
                grasps.back().score += product;
                grasps.back().interval.end = block.interval(run).end;
            } else {
                grasps.push_back({product, block.interval(run)});
            }
            held = run.last == block.jaw.size();
        }
    }
    std::stable_sort(grasps.begin(), grasps.end(),
                     [](const ScoredInterval& a, const ScoredInterval& b) { return a.score > b.score; });
    return grasps;
}

Figure grasp_ftp(const Analysis& analysis, const Selection& row) {
    std::vector<ScoredInterval> grasps = grasps_of(analysis, row);
    if (grasps.empty()) return no_grasp();
    Figure figure;
    figure.value = grasps.front().score;
    figure.count = static_cast<int>(grasps.size());
    figure.evidence = worst_first(std::move(grasps));
    return figure;
}

Figure grasp_ftp_patch(const Analysis& analysis, const Selection& row) {
    struct Patch {
        double product = 0;
        std::vector<ScoredInterval> grasps;
    };
    std::map<std::pair<int, int>, Patch> patches;  // by tissue and patch
    for (const ForceBlock& block : analysis.hand(row.hand).force)
        for (const Run& grasp :
             runs_of(block.jaw.size(), [&](std::size_t i) { return grasping(block, i, row); })) {
            // A grasp may slide from patch to patch; each patch gets its share.
            for (std::size_t first = grasp.first; first < grasp.last;) {
                std::size_t last = first + 1;
                while (last < grasp.last && block.patch[last] == block.patch[first]) ++last;
                double product = 0;
                for (std::size_t i = first; i < last; ++i) product += block.jaw[i] / force_rate;
                if (block.patch[first] >= 0) {
                    const int tissue = block.tissue.empty() ? -1 : block.tissue[first];
                    Patch& patch = patches[{tissue, block.patch[first]}];
                    patch.product += product;
                    patch.grasps.push_back({product, block.interval({first, last})});
                }
                first = last;
            }
        }
    const auto worst = std::max_element(patches.begin(), patches.end(), [](const auto& a, const auto& b) {
        return a.second.product < b.second.product;
    });
    if (worst == patches.end()) return no_grasp();
    Figure figure;
    figure.value = worst->second.product;
    figure.evidence = worst_first(worst->second.grasps);
    return figure;
}

constexpr double new_contact_s = 0.1;  // s without contact after which a contact counts as a new one

/// Number of contacts of the instrument with the row's tissue.
Figure contacts(const Analysis& analysis, const Selection& row) {
    std::vector<ScoredInterval> touches;
    for (const ForceBlock& block : analysis.hand(row.hand).force) {
        double left = -new_contact_s;
        for (const Run& run : runs_of(block.tissue.size(), [&](std::size_t i) {
                 return row.tissue < 0 ? block.tissue[i] >= 0 : block.tissue[i] == row.tissue;
             })) {
            const TimeInterval when = block.interval(run);
            if (when.begin - left >= new_contact_s) touches.push_back({when.end - when.begin, when});
            left = when.end;
        }
    }
    Figure figure;
    figure.value = static_cast<double>(touches.size());
    figure.evidence = worst_first(std::move(touches));
    return figure;
}

}  // namespace

// Long because: a table, one entry for each metric.
std::vector<Metric> grasp_metrics() {
    using D = Direction;
    using A = Aggregation;
    using E = EvidenceGrade;
    std::vector<Metric> metrics;
    const auto add_grasp = [&](MetricDescriptor d, std::vector<Channel> channels,
                               Figure (*compute)(const Analysis&, const Selection&)) {
        d.filter = force_filter;
        d.version = force_filter_version;
        d.per_tissue = true;
        d.channels = std::move(channels);
        d.absent_means = AbsentMeans::failed;
        metrics.push_back({std::move(d), compute});
    };
    add_grasp(
        describe({"grasp_max", QT_TRANSLATE_NOOP("fulcrum::metrics", "Largest jaw force"), "N", 0.1},
                 D::lower, Scale::raw, A::maximum, E::moderate, "Barrie 2018",
                 {QT_TRANSLATE_NOOP("fulcrum::metrics", "Largest force of the jaws on tissue."),
                  QT_TRANSLATE_NOOP("fulcrum::metrics",
                                    "the jaws pressed with {value}, above the limit of {limit}"),
                  QT_TRANSLATE_NOOP("fulcrum::metrics", "close only until the tissue no longer slips")}),
        {Channel::jaw_force}, grasp_max);
    add_grasp(
        describe(
            {"grasp_ftp", QT_TRANSLATE_NOOP("fulcrum::metrics", "Force-time product of a grasp"), "N·s", 0.1},
            D::lower, Scale::raw, A::maximum, E::moderate, "Barrie 2018",
            {QT_TRANSLATE_NOOP("fulcrum::metrics",
                               "Jaw force integrated over one grasp, the largest of all grasps. A pause does "
                               "not end a grasp."),
             QT_TRANSLATE_NOOP("fulcrum::metrics",
                               "the force-time product of one grasp was {value}, above the limit of {limit}"),
             QT_TRANSLATE_NOOP("fulcrum::metrics", "let go and take a new hold from time to time")}),
        {Channel::jaw_force}, grasp_ftp);
    metrics.back().descriptor.version = 3;  // 3: one grasp before and after a pause
    add_grasp(
        describe(
            {"grasp_ftp_patch", QT_TRANSLATE_NOOP("fulcrum::metrics", "Force-time product of a patch"), "N·s",
             0.1},
            D::lower, Scale::raw, A::maximum, E::moderate, "Barrie 2018",
            {QT_TRANSLATE_NOOP(
                 "fulcrum::metrics",
                 "Jaw force integrated over all grasps of one patch of tissue, the largest of all patches."),
             QT_TRANSLATE_NOOP("fulcrum::metrics",
                               "the force-time product of one patch was {value}, above the limit of {limit}"),
             QT_TRANSLATE_NOOP("fulcrum::metrics", "grasp next to the place used before")}),
        {Channel::jaw_force, Channel::patch}, grasp_ftp_patch);
    add_grasp(describe({"grasp_kpa", QT_TRANSLATE_NOOP("fulcrum::metrics", "Largest jaw pressure"), "kPa", 1},
                       D::lower, Scale::raw, A::maximum, E::moderate,
                       "BMJ Surgery, Interventions & Health Technologies 2021: 329-330 kPa safe for 10 s",
                       {QT_TRANSLATE_NOOP("fulcrum::metrics", "Largest jaw force over the area of contact."),
                        QT_TRANSLATE_NOOP("fulcrum::metrics",
                                          "the jaws pressed with {value}, above the limit of {limit}"),
                        QT_TRANSLATE_NOOP("fulcrum::metrics",
                                          "take a full bite, and avoid holding tissue with the tips")}),
              {Channel::jaw_force, Channel::jaw_area}, grasp_kpa);
    add_grasp(
        describe({"contacts", QT_TRANSLATE_NOOP("fulcrum::metrics", "Contacts with tissue"), "-", 1},
                 D::context, Scale::raw, A::count, E::expert, "contacts 0.1 s apart; our own definition",
                 {QT_TRANSLATE_NOOP("fulcrum::metrics",
                                    "Number of times the instrument came into contact with tissue."),
                  QT_TRANSLATE_NOOP("fulcrum::metrics", "the instrument touched tissue {value} times"),
                  QT_TRANSLATE_NOOP("fulcrum::metrics", "come once and stay")}),
        {Channel::force, Channel::tissue}, contacts);

    const auto add_count = [&](Naming naming, bool per_tissue, const char* source, Wording wording,
                               Figure (*compute)(const Analysis&, const Selection&)) {
        MetricDescriptor d = describe(std::move(naming), D::lower, Scale::raw, A::count, E::moderate, source,
                                      std::move(wording));
        d.filter = no_filter;
        d.per_tissue = per_tissue;
        d.needs_events = true;
        metrics.push_back({std::move(d), compute});
    };
    add_count(
        {"slip", QT_TRANSLATE_NOOP("fulcrum::metrics", "Slips"), "-", 1}, true,
        "event: tissue left the jaws against the operator's will",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "Number of times tissue slipped out of the jaws."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "tissue slipped {value} times, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "take a larger bite before you apply traction")},
        counted<EventKind::slip>);
    add_count(
        {"regrasp", QT_TRANSLATE_NOOP("fulcrum::metrics", "Repeated grasps"), "-", 1}, true,
        "event: the same patch, or a place of a sheet nearer than the jaws are long, grasped again "
        "within 2 s, pauses excluded",
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Number of times the same patch was grasped again within 2 s of release."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "the same place was grasped again {value} times, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "place the jaws where you will apply traction, then close once")},
        counted<EventKind::regrasp>);
    add_count(
        {"drop", QT_TRANSLATE_NOOP("fulcrum::metrics", "Drops"), "-", 1}, false, "event: a held object fell",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "Number of objects dropped."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "{value} objects were dropped, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "release it only when the object rests")},
        counted<EventKind::drop>);
    add_count(
        {"perforation", QT_TRANSLATE_NOOP("fulcrum::metrics", "Perforations"), "-", 1}, true,
        "event, critical",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "Number of perforations."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "the bowel was perforated {value} times, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "keep the tips in view and never push against resistance")},
        counted<EventKind::perforation>);
    return metrics;
}

}  // namespace fulcrum
