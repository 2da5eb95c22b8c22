// SPDX-License-Identifier: Apache-2.0
#include "assessment/pathology/pathology.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/name_table.h"

namespace fulcrum {

namespace {

constexpr double same_defect = 0.001;  // m between two stretches that are one defect
constexpr double at_rim = 3e-6;        // m from the end of a level's line: its rim

double height_of(const SpecimenPlan& plan, double distance) {
    return plan.plane - distance;
}
double depth_of(const SpecimenPlan& plan, double distance) {
    return std::clamp(height_of(plan, distance) - plan.areolar, 0.0, std::max(0.0, plan.fat - plan.areolar));
}

bool usable(const CutElement& e) {
    return std::isfinite(e.from) && std::isfinite(e.to) && std::isfinite(e.from_distance) &&
           std::isfinite(e.distance) && std::isfinite(e.length) && e.length > 0;
}

/// Whether an element lies on one level. A blade that runs over a rim is reported as at the rim: a path along
/// it, or from one level to the next, is no surface of the specimen.
bool on_one_level(const CutElement& e, const SpecimenPlan& plan) {
    const double low = std::min(e.from, e.to), high = std::max(e.from, e.to);
    const double rim = plan.line * std::round(0.5 * (low + high) / plan.line);
    if (std::abs(low - rim) <= at_rim && std::abs(high - rim) <= at_rim) return false;
    for (int k = 1; k < plan.levels; ++k) {
        if (low < k * plan.line - at_rim && high > k * plan.line + at_rim) return false;
    }
    return true;
}

CutElement part_of(const CutElement& whole, double first, double last) {
    CutElement part = whole;
    part.from = whole.from + first * (whole.to - whole.from);
    part.to = whole.from + last * (whole.to - whole.from);
    part.from_distance = whole.from_distance + first * (whole.distance - whole.from_distance);
    part.distance = whole.from_distance + last * (whole.distance - whole.from_distance);
    part.length = (last - first) * whole.length;
    return part;
}

/// The cut sorted into levels and sectors; positions within a cell are counted from the cell's right end.
class Specimen {
  public:
    Specimen(const std::vector<CutStroke>& strokes, const SpecimenPlan& plan)
        : cells_(static_cast<std::size_t>(plan.levels * sector_count)),
          width_(plan.line / sector_count),
          asked_(plan.asked_length()) {
        for (const CutStroke& stroke : strokes)
            for (const CutElement& element : stroke.elements)
                if (usable(element) && on_one_level(element, plan)) add(element);
    }
    std::size_t cells() const { return cells_.size(); }
    const CutStroke& cell(int level, int sector) const {
        return cells_[static_cast<std::size_t>(level * sector_count + sector)];
    }
    double width() const { return width_; }
    /// How much of a cell's line the task asks for, from its right end; 0 to 1.
    double asked_share(int level, int sector) const {
        const double begin = (level * sector_count + sector) * width_;
        if (asked_ >= begin + width_ - resolution) return 1;
        return std::max(0.0, asked_ - begin) / width_;
    }
    /// The sum of these shares over a level, and over a sector of all levels.
    double asked_of_level(int level) const {
        double sum = 0;
        for (int sector = 0; sector < sector_count; ++sector) sum += asked_share(level, sector);
        return sum;
    }
    double asked_of_sector(int sector) const {
        double sum = 0;
        for (int level = 0; level * sector_count < static_cast<int>(cells_.size()); ++level)
            sum += asked_share(level, sector);
        return sum;
    }

  private:
    void add(const CutElement& element) {
        // Where the element leaves one cell for the next; beyond either end of the line it stays in the last.
        std::vector<double> borders{0.0};
        const double span = element.to - element.from;
        for (std::size_t k = 1; k < cells_.size() && span != 0; ++k) {
            const double at = (static_cast<double>(k) * width_ - element.from) / span;
            if (at > 0 && at < 1) borders.push_back(at);
        }
        std::sort(borders.begin(), borders.end());
        borders.push_back(1.0);
        for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
            CutElement part = part_of(element, borders[i], borders[i + 1]);
            const double middle = std::floor(0.5 * (part.from + part.to) / width_);
            const double last = static_cast<double>(cells_.size() - 1);
            const auto index = static_cast<std::size_t>(std::clamp(middle, 0.0, last));
            part.from -= static_cast<double>(index) * width_;
            part.to -= static_cast<double>(index) * width_;
            cells_[index].elements.push_back(part);
        }
    }

    std::vector<CutStroke> cells_;
    double width_, asked_;
};

PlaneDeviation deviation(const std::vector<CutStroke>& cells, double tolerance) {
    PlaneDeviation plane;
    double deep = 0, shallow = 0, worst = 0;
    for (const CutStroke& cell : cells) {
        for (CutElement element : cell.elements) {
            plane.length += element.length;
            for (const double distance : {element.from_distance, element.distance})
                if (std::abs(distance) > std::abs(worst)) worst = distance;
            deep += element.length * share_beyond(element, tolerance);
            element.from_distance = -element.from_distance;
            element.distance = -element.distance;
            shallow += element.length * share_beyond(element, tolerance);
        }
    }
    if (!(plane.length > 0)) return plane;
    plane.median = distance_quantile(cells, 0.5, true);
    plane.p95 = distance_quantile(cells, 0.95, true);
    plane.side = distance_quantile(cells, 0.5, false);
    plane.worst = worst;
    plane.too_deep = deep / plane.length;
    plane.too_shallow = shallow / plane.length;
    plane.in_plane = std::max(0.0, 1 - *plane.too_deep - *plane.too_shallow);
    return plane;
}

/// The stretches of one level that lie in the fat, joined where they touch.
void add_defects(const Specimen& specimen, const SpecimenPlan& plan, int level,
                 std::vector<Defect>& defects) {
    std::vector<Defect> stretches;
    for (int sector = 0; sector < sector_count; ++sector) {
        const double origin = sector * specimen.width();
        for (CutElement element : specimen.cell(level, sector).elements) {
            // Distances from where the fat begins, counted inwards.
            const double border = plan.areolar - plan.plane;
            element.from_distance = -element.from_distance - border;
            element.distance = -element.distance - border;
            const double share = share_beyond(element, 0);
            if (!(share > 0)) continue;
            double first = 0, last = 1;
            if (share < 1)
                (element.from_distance > 0 ? last : first) = element.from_distance > 0 ? share : 1 - share;
            const double a = element.from + first * (element.to - element.from);
            const double b = element.from + last * (element.to - element.from);
            const double depth = std::max(element.from_distance, element.distance);
            const double top = plan.fat - plan.areolar;
            stretches.push_back({level,
                                 origin + std::min(a, b),
                                 origin + std::max(a, b),
                                 std::clamp(depth, 0.0, std::max(0.0, top)),
                                 depth >= top - muscularis_reach,
                                 {element.begin, element.end}});
        }
    }
    std::sort(stretches.begin(), stretches.end(),
              [](const Defect& a, const Defect& b) { return a.from < b.from; });
    std::vector<Defect> joined;
    for (const Defect& stretch : stretches) {
        if (joined.empty() || stretch.from > joined.back().to + same_defect) {
            joined.push_back(stretch);
            continue;
        }
        Defect& one = joined.back();
        one.to = std::max(one.to, stretch.to);
        one.muscularis = one.muscularis || stretch.muscularis;
        if (stretch.depth > one.depth) {  // seen where it is deepest
            one.depth = stretch.depth;
            one.when = stretch.when;
        }
    }
    for (const Defect& defect : joined)
        if (defect.depth > least_defect || defect.muscularis) defects.push_back(defect);
}

/// Slope of the levels' medians by least squares, times the levels' span.
std::optional<double> coning_of(const Specimen& specimen, const SpecimenPlan& plan,
                                const std::vector<double>& divided) {
    std::vector<std::pair<double, double>> medians;  // level, m inwards
    for (int level = 0; level < plan.levels; ++level) {
        if (divided[static_cast<std::size_t>(level)] < judged_share) continue;
        std::vector<CutStroke> cells;
        for (int sector = 0; sector < sector_count; ++sector) cells.push_back(specimen.cell(level, sector));
        if (const auto side = distance_quantile(cells, 0.5, false)) medians.emplace_back(level, -*side);
    }
    if (medians.size() < static_cast<std::size_t>(least_levels_of_coning)) return std::nullopt;
    double mean_level = 0, mean_inward = 0;
    for (const auto& [level, inward] : medians) {
        mean_level += level / static_cast<double>(medians.size());
        mean_inward += inward / static_cast<double>(medians.size());
    }
    double sum = 0, squares = 0;
    for (const auto& [level, inward] : medians) {
        sum += (level - mean_level) * (inward - mean_inward);
        squares += (level - mean_level) * (level - mean_level);
    }
    return sum / squares * (medians.back().first - medians.front().first);
}

/// Least distance of a straight piece of cut to the tumour within its level, m. The distance to a box is
/// convex along the piece.
double distance_to_tumour(const CutElement& element, double origin, const SpecimenPlan& plan) {
    const double width = plan.line / sector_count;
    const double x0 = static_cast<int>(plan.tumour->sector) * width, x1 = x0 + width;
    const double y0 = plan.fat - plan.tumour->depth, y1 = plan.fat;
    const auto at = [&](double t) {
        const double x = origin + element.from + t * (element.to - element.from);
        const double y =
            height_of(plan, element.from_distance + t * (element.distance - element.from_distance));
        return std::hypot(std::max({0.0, x0 - x, x - x1}), std::max({0.0, y0 - y, y - y1}));
    };
    double first = 0, last = 1;
    for (int i = 0; i < 60; ++i) {
        const double a = first + (last - first) / 3, b = last - (last - first) / 3;
        (at(a) < at(b) ? last : first) = at(a) < at(b) ? b : a;
    }
    return std::min({at(0), at(1), at(0.5 * (first + last))});
}

Margin circumferential_margin(const Specimen& specimen, const SpecimenPlan& plan,
                              const std::vector<SectorFinding>& findings) {
    Margin margin;
    if (!plan.tumour) return margin;
    const Tumour& tumour = *plan.tumour;
    margin.absence = MarginAbsence::not_divided;
    const auto at_tumour = [&](const SectorFinding& finding) {
        return finding.level == tumour.level && finding.sector == tumour.sector;
    };
    const auto found = std::find_if(findings.begin(), findings.end(), at_tumour);
    if (found == findings.end() || found->divided < fully_divided_share - 1e-9) return margin;
    margin.absence = MarginAbsence::none;
    for (int level = 0; level < plan.levels; ++level) {
        const double apart =
            std::max(0.0, std::abs(level - tumour.level) * plan.spacing - 0.5 * tumour.length);
        const double away = level == tumour.level ? 0.0 : apart;
        for (int sector = 0; sector < sector_count; ++sector) {
            for (const CutElement& element : specimen.cell(level, sector).elements) {
                const double distance =
                    std::hypot(away, distance_to_tumour(element, sector * specimen.width(), plan));
                if (margin.distance && distance >= *margin.distance) continue;
                margin.distance = distance;
                margin.when = {element.begin, element.end};
            }
        }
    }
    return margin;
}

Margin distal_margin(const SpecimenPlan& plan, int lowest_level) {
    Margin margin;
    if (!plan.tumour) return margin;
    const double reach = lowest_level * plan.spacing;
    const double edge = plan.tumour->level * plan.spacing + 0.5 * plan.tumour->length;
    margin.absence = MarginAbsence::not_divided;
    if (lowest_level < 0 || reach < edge) return margin;
    margin.absence = MarginAbsence::none;
    margin.distance = reach - edge;
    return margin;
}

/// How much of the cut lies deep in the fat, and its median depth there.
void measure_fat(PathologyReport& report, const std::vector<CutStroke>& cells) {
    const SpecimenPlan& plan = report.plan;
    if (!(report.plane.length > 0)) return;
    double entered = 0;
    for (const CutStroke& cell : cells) {
        for (CutElement element : cell.elements) {
            element.from_distance = height_of(plan, element.from_distance) - plan.areolar;
            element.distance = height_of(plan, element.distance) - plan.areolar;
            entered += element.length * share_beyond(element, fat_entered + resolution);
        }
    }
    report.fat_share = entered / report.plane.length;
    report.median_fat_depth = depth_of(plan, *report.plane.side);
}

void judge(PathologyReport& report) {
    if (!(report.plane.length > 0)) return;
    if (report.divided < fully_divided_share - 1e-9) {
        report.reasons = {GradeReason::undivided};
        return;
    }
    const bool wall = std::any_of(report.defects.begin(), report.defects.end(),
                                  [](const Defect& defect) { return defect.muscularis; });
    const auto above = [](double value, double limit) { return value > limit + resolution; };
    const double coning = report.coning.value_or(0);
    std::vector<GradeReason> found;
    if (report.perforated) found.push_back(GradeReason::perforation);
    if (wall) found.push_back(GradeReason::muscularis);
    if (above(report.median_fat_depth, bulk_loss_depth)) found.push_back(GradeReason::bulk_loss);
    if (above(coning, deep_coning_limit)) found.push_back(GradeReason::deep_coning);
    if (found.empty()) {
        if (above(report.deepest_defect, deep_defect)) found.push_back(GradeReason::defect);
        if (report.fat_share > fat_share_limit + 1e-9) found.push_back(GradeReason::fat);
        if (above(coning, coning_limit)) found.push_back(GradeReason::coning);
    }
    if (found.empty()) found.push_back(GradeReason::intact);
    report.grade = grade_of(found.front());
    report.reasons = std::move(found);
}

/// What a reason is called in documents, and its grade.
struct ReasonRow {
    GradeReason kind;
    const char* name;
    int grade;
};
constexpr ReasonRow reasons[] = {
    {GradeReason::nothing_cut, "nothing_cut", 0},
    {GradeReason::undivided, "undivided", 0},
    {GradeReason::intact, "intact", 3},
    {GradeReason::defect, "defect", 2},
    {GradeReason::fat, "fat", 2},
    {GradeReason::coning, "coning", 2},
    {GradeReason::muscularis, "muscularis", 1},
    {GradeReason::bulk_loss, "bulk_loss", 1},
    {GradeReason::deep_coning, "deep_coning", 1},
    {GradeReason::perforation, "perforation", 1},
};
static_assert(in_order(reasons));

}  // namespace

const char* sector_name(Sector sector) {
    switch (sector) {
        case Sector::right:
            return "right";
        case Sector::mid:
            return "mid";
        case Sector::left:
            return "left";
    }
    return "mid";
}

const char* grade_reason_name(GradeReason reason) {
    return row_of(reasons, reason).name;
}

int grade_of(GradeReason reason) {
    return row_of(reasons, reason).grade;
}

const char* margin_absence_name(MarginAbsence absence) {
    switch (absence) {
        case MarginAbsence::none:
            return "none";
        case MarginAbsence::no_tumour:
            return "no_tumour";
        case MarginAbsence::not_divided:
            return "not_divided";
    }
    return "no_tumour";
}

bool margin_is_positive(const Margin& margin) {
    return margin.distance && *margin.distance <= positive_margin + resolution;
}

PathologyReport pathology_report(const std::vector<CutStroke>& strokes, const SpecimenPlan& plan,
                                 bool perforated) {
    PathologyReport report;
    report.plan = plan;
    report.perforated = perforated;
    for (int sector = 0; sector < sector_count; ++sector)
        report.sectors[static_cast<std::size_t>(sector)] = {-1, static_cast<Sector>(sector), {}, 0, 0};
    if (plan.levels < 1 || !(plan.line > 0)) return report;
    const Specimen specimen(strokes, plan);
    std::vector<CutStroke> whole;
    std::array<std::vector<CutStroke>, sector_count> by_sector;
    std::vector<double> divided(static_cast<std::size_t>(plan.levels), 0.0);
    double levels_asked = 0;
    for (int level = 0; level < plan.levels; ++level)
        levels_asked += specimen.asked_of_level(level) / sector_count;
    for (int level = 0; level < plan.levels; ++level) {
        const double of_level = specimen.asked_of_level(level);
        for (int sector = 0; sector < sector_count; ++sector) {
            const CutStroke& cell = specimen.cell(level, sector);
            SectorFinding finding{level, static_cast<Sector>(sector), deviation({cell}, plan.tolerance), 0,
                                  0};
            // What is not asked for has no weight in what follows, but is shown.
            const double share = specimen.asked_share(level, sector);
            const double length = (share > 0 ? share : 1) * specimen.width();
            finding.divided = divided_length({cell}, length, plan.corridor) / length;
            for (const CutElement& element : cell.elements)
                finding.defect = std::max({finding.defect, depth_of(plan, element.from_distance),
                                           depth_of(plan, element.distance)});
            SectorFinding& all = report.sectors[static_cast<std::size_t>(sector)];
            if (share > 0) {
                divided[static_cast<std::size_t>(level)] += finding.divided * share / of_level;
                all.divided += finding.divided * share / specimen.asked_of_sector(sector);
            }
            all.defect = std::max(all.defect, finding.defect);
            report.deepest_defect = std::max(report.deepest_defect, finding.defect);
            report.findings.push_back(std::move(finding));
            by_sector[static_cast<std::size_t>(sector)].push_back(cell);
            whole.push_back(cell);
        }
        report.divided += divided[static_cast<std::size_t>(level)] * (of_level / sector_count) / levels_asked;
        if (report.lowest_level == level - 1 &&
            divided[static_cast<std::size_t>(level)] >= fully_divided_share)
            report.lowest_level = level;
        add_defects(specimen, plan, level, report.defects);
    }
    for (std::size_t sector = 0; sector < sector_count; ++sector)
        report.sectors[sector].plane = deviation(by_sector[sector], plan.tolerance);
    report.plane = deviation(whole, plan.tolerance);
    std::stable_sort(report.defects.begin(), report.defects.end(),
                     [](const Defect& a, const Defect& b) { return a.depth > b.depth; });
    report.coning = coning_of(specimen, plan, divided);
    measure_fat(report, whole);
    report.circumferential = circumferential_margin(specimen, plan, report.findings);
    report.distal = distal_margin(plan, report.lowest_level);
    judge(report);
    if (report.defects.size() > most_defects) report.defects.resize(most_defects);
    return report;
}

PathologyReport pathology_of_events(const std::vector<Event>& events, double tick_period, double end,
                                    const SpecimenPlan& plan) {
    const bool perforated = std::any_of(events.begin(), events.end(), [](const Event& event) {
        return event.kind == EventKind::perforation;
    });
    return pathology_report(cut_strokes(events, tick_period, end), plan, perforated);
}

}  // namespace fulcrum
