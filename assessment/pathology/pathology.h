// SPDX-License-Identifier: Apache-2.0
// A simulated pathology report on the specimen of a dissection, from the cut surface alone: distance of the
// cut from the intended plane, depth in the mesorectum, margins. All positions are those of the tissue at
// rest.
//
// The dissected tissue is a row of levels, each a strip between the sacrum's fascia (height 0) and the wall
// of the rectum (height `fat`), bridged by areolar tissue (to `areolar`) and mesorectal fat. The intended
// plane lies at height `plane`. Positions along the marked line run through the levels from cranial to
// caudal, in each from the patient's right to the left. A cut at signed distance d (positive towards the
// sacrum: too deep) has height plane - d.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/trace/cut_strokes.h"

namespace fulcrum {

enum class Sector : std::uint8_t { right, mid, left };  ///< the patient's; a third of a level each
inline constexpr int sector_count = 3;
const char* sector_name(Sector sector);

/// A tumour of the rectum's wall that grows outwards into the mesorectum.
struct Tumour {
    int level = 0;  ///< 0 most cranial
    Sector sector = Sector::mid;
    double depth = 0;   ///< m, from the muscularis outwards
    double length = 0;  ///< m, craniocaudal, centred on its level
};

/// The data of scene and task for the report. Lengths in m.
struct SpecimenPlan {
    int levels = 0;
    double line = 0;     ///< of the marked line on one level
    double spacing = 0;  ///< between levels, craniocaudal
    double plane = 0, areolar = 0,
           fat = 0;        ///< heights: intended plane, end of the areolar layer, muscularis
    double tolerance = 0;  ///< further from the plane is too deep or too shallow
    double corridor = 0;   ///< further from the plane divides nothing of it
    std::optional<Tumour> tumour;
    double asked = 0;  ///< of the whole marked line, from its beginning: what the task asks for; 0 all of it

    double asked_length() const { return asked > 0 ? asked : levels * line; }
};

// Quirke's grades ask for defects deeper than 5 mm, for coning, and for the muscularis; the other limits are
// ours. A value equal to a limit is on the better side of it, except the margin, which is positive at its
// limit. Values are compared as computed, never as shown; within `resolution` they are equal.
inline constexpr double resolution = 1e-8;          ///< m, a tenth of the record's
inline constexpr double deep_defect = 0.005;        ///< m into the fat
inline constexpr double fat_entered = 0.002;        ///< m into the fat
inline constexpr double fat_share_limit = 0.2;      ///< of the cut's length deeper than fat_entered: grade 2
inline constexpr double bulk_loss_depth = 0.008;    ///< m, median depth into the fat: grade 1
inline constexpr double deep_coning_limit = 0.006;  ///< m, as coning_limit: grade 1
inline constexpr double least_defect = 0.001;       ///< m, a shallower scratch is not listed
inline constexpr double muscularis_reach = 0.001;   ///< m from the muscularis counts as there
inline constexpr double positive_margin = 0.001;    ///< m, a circumferential margin of this or less
inline constexpr double coning_limit = 0.003;  ///< m inwards from the first judged level to the last: grade 2
inline constexpr int least_levels_of_coning = 3;  ///< a trend needs as many levels
inline constexpr double judged_share = 0.5;       ///< of a level's line: less divided is not in the trend
inline constexpr double fully_divided_share =
    0.95;  ///< of a level's line; of the whole line, for a grade; of the tumour's sector, for its margin;
           ///< each as far as the task asks for it
inline constexpr std::size_t most_defects = 20;  ///< listed, deepest first

/// Distances from the plane over a part of the cut, by length; absent where nothing was cut.
struct PlaneDeviation {
    double length = 0;                                      ///< m of cut
    std::optional<double> median, p95;                      ///< m, of the size of the distance
    std::optional<double> side;                             ///< m, median of the signed distance
    std::optional<double> worst;                            ///< m, the signed distance of largest size
    std::optional<double> in_plane, too_deep, too_shallow;  ///< shares of the length, together 1
};

struct SectorFinding {
    int level = 0;  ///< -1: all levels
    Sector sector = Sector::mid;
    PlaneDeviation plane;
    double divided = 0;  ///< share of its part of the line, as far as the task asks for it, 0 to 1
    double defect = 0;   ///< m, deepest into the fat
};

/// A stretch of the cut that lies in the fat.
struct Defect {
    int level = 0;
    double from = 0, to = 0;  ///< m along the level's line, from the patient's right
    double depth = 0;         ///< m into the fat, greatest
    bool muscularis = false;  ///< reaches the wall
    TimeInterval when;        ///< s, of the attempt
};

enum class GradeReason : std::uint8_t {
    nothing_cut,  ///< no grade
    undivided,    ///< no grade: less than 95 % of the line is divided
    intact,       ///< 3
    defect,       ///< 2: deeper than 5 mm
    fat,          ///< 2: more than a fifth of the cut is more than 2 mm in the fat
    coning,       ///< 2: the cut runs towards the rectum from level to level
    muscularis,   ///< 1: a defect down to the wall
    bulk_loss,    ///< 1: the median of the cut is more than 8 mm in the fat
    deep_coning,  ///< 1
    perforation,  ///< 1: the bowel was perforated
};
const char* grade_reason_name(GradeReason reason);
/// 3 complete, 2 nearly complete, 1 incomplete; 0: no grade.
int grade_of(GradeReason reason);

enum class MarginAbsence : std::uint8_t {
    none,         ///< there is a margin
    no_tumour,    ///< the case has none
    not_divided,  ///< the tumour's sector is not divided, or nothing beyond the tumour
};
const char* margin_absence_name(MarginAbsence absence);

struct Margin {
    std::optional<double> distance;  ///< m
    MarginAbsence absence = MarginAbsence::no_tumour;
    TimeInterval when;  ///< s, of the element that is nearest; circumferential only
};

struct PathologyReport {
    int version = 4;  ///< of this function; changes whenever a figure could
    SpecimenPlan plan;
    double divided = 0;  ///< share of the whole line that the task asks for
    PlaneDeviation plane;
    std::vector<SectorFinding> findings;              ///< by level, then sector
    std::array<SectorFinding, sector_count> sectors;  ///< all levels together
    std::vector<Defect> defects;                      ///< deepest first, at most most_defects
    double deepest_defect = 0;                        ///< m
    std::optional<double> coning;  ///< m inwards over the judged levels, by least squares over their medians;
                                   ///< absent below least_levels_of_coning
    double fat_share = 0;          ///< of the cut's length, deeper in the fat than fat_entered
    double median_fat_depth = 0;   ///< m, of the cut into the fat
    bool perforated = false;       ///< the bowel
    std::optional<int> grade;      ///< 3 complete, 2 nearly complete, 1 incomplete
    std::vector<GradeReason> reasons{GradeReason::nothing_cut};  ///< all that give this grade, at least one
    Margin circumferential;  ///< least distance of the cut to the tumour's edge; 0 within it
    Margin distal;  ///< from the tumour's lower edge to the lowest level reached; nothing is transected
    int lowest_level = -1;  ///< the levels down to this one are fully divided; -1 none
};

/// Of 1 mm or less; false without a margin.
bool margin_is_positive(const Margin& margin);

/// Pure. Strokes as cut_strokes() gives them; what of them is not a number is left out, as are ways along a
/// rim of a level and from one level to the next. `perforated`: the bowel was perforated during the attempt.
PathologyReport pathology_report(const std::vector<CutStroke>& strokes, const SpecimenPlan& plan,
                                 bool perforated = false);
/// From the events of an attempt; `end` in s.
PathologyReport pathology_of_events(const std::vector<Event>& events, double tick_period, double end,
                                    const SpecimenPlan& plan);

/// The report as one JSON document, lengths in mm, shares in percent; what the store keeps and exports show.
std::string pathology_json(const PathologyReport& report);
/// Its reverse. Throws InputError naming `file` and the JSON pointer.
PathologyReport parse_pathology(const std::string& text, const std::string& file);

}  // namespace fulcrum
