// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <nlohmann/json.hpp>

#include "assessment/pathology/pathology.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {

namespace {

using Json = nlohmann::ordered_json;

constexpr double mm = 1e3, percent = 1e2;

/// In a unit of people, to a millionth: what is read back and written again is the same text.
double scaled(double value, double unit) {
    return std::round(value * unit * 1e6) / 1e6;
}
Json scaled(const std::optional<double>& value, double unit) {
    return value ? Json(scaled(*value, unit)) : Json(nullptr);
}
std::optional<double> unscaled(const Json& node, double unit) {
    return node.is_null() ? std::nullopt : std::optional<double>(node.get<double>() / unit);
}

Json plane_json(const PlaneDeviation& plane) {
    return {{"length_mm", scaled(plane.length, mm)},
            {"median_mm", scaled(plane.median, mm)},
            {"p95_mm", scaled(plane.p95, mm)},
            {"side_mm", scaled(plane.side, mm)},
            {"worst_mm", scaled(plane.worst, mm)},
            {"in_plane_percent", scaled(plane.in_plane, percent)},
            {"too_deep_percent", scaled(plane.too_deep, percent)},
            {"too_shallow_percent", scaled(plane.too_shallow, percent)}};
}
PlaneDeviation plane_from(const Json& node) {
    PlaneDeviation plane;
    plane.length = node.at("length_mm").get<double>() / mm;
    plane.median = unscaled(node.at("median_mm"), mm);
    plane.p95 = unscaled(node.at("p95_mm"), mm);
    plane.side = unscaled(node.at("side_mm"), mm);
    plane.worst = unscaled(node.at("worst_mm"), mm);
    plane.in_plane = unscaled(node.at("in_plane_percent"), percent);
    plane.too_deep = unscaled(node.at("too_deep_percent"), percent);
    plane.too_shallow = unscaled(node.at("too_shallow_percent"), percent);
    return plane;
}

Json finding_json(const SectorFinding& finding) {
    Json node = {{"level", finding.level < 0 ? Json(nullptr) : Json(finding.level)},
                 {"sector", sector_name(finding.sector)},
                 {"divided_percent", scaled(finding.divided, percent)},
                 {"defect_mm", scaled(finding.defect, mm)}};
    node.update(plane_json(finding.plane));
    return node;
}

template <typename Value, typename Name>
Value named(const Json& node, std::initializer_list<Value> values, Name name) {
    const auto text = node.get<std::string>();
    for (const Value value : values)
        if (text == name(value)) return value;
    throw Json::other_error::create(501, "\"" + text + "\" is not known here", &node);
}

Sector sector_from(const Json& node) {
    return named(node, {Sector::right, Sector::mid, Sector::left}, sector_name);
}

SectorFinding finding_from(const Json& node) {
    SectorFinding finding;
    finding.level = node.at("level").is_null() ? -1 : node.at("level").get<int>();
    finding.sector = sector_from(node.at("sector"));
    finding.divided = node.at("divided_percent").get<double>() / percent;
    finding.defect = node.at("defect_mm").get<double>() / mm;
    finding.plane = plane_from(node);
    return finding;
}

Json interval_json(const TimeInterval& when) {
    return Json::array({when.begin, when.end});
}
TimeInterval interval_from(const Json& node) {
    return {node.at(0).get<double>(), node.at(1).get<double>()};
}

Json margin_json(const Margin& margin) {
    Json node = {
        {"mm", scaled(margin.distance, mm)},
        {"absent_because",
         margin.absence == MarginAbsence::none ? Json(nullptr) : Json(margin_absence_name(margin.absence))}};
    node["when_s"] = interval_json(margin.when);
    return node;
}
Margin margin_from(const Json& node) {
    Margin margin;
    margin.distance = unscaled(node.at("mm"), mm);
    margin.absence = node.at("absent_because").is_null()
                         ? MarginAbsence::none
                         : named(node.at("absent_because"),
                                 {MarginAbsence::no_tumour, MarginAbsence::not_divided}, margin_absence_name);
    margin.when = interval_from(node.at("when_s"));
    return margin;
}

Json specimen_json(const SpecimenPlan& plan) {
    Json node = {{"levels", plan.levels},
                 {"line_mm", scaled(plan.line, mm)},
                 {"asked_mm", scaled(plan.asked_length(), mm)},
                 {"spacing_mm", scaled(plan.spacing, mm)},
                 {"plane_mm", scaled(plan.plane, mm)},
                 {"areolar_mm", scaled(plan.areolar, mm)},
                 {"muscularis_mm", scaled(plan.fat, mm)},
                 {"tolerance_mm", scaled(plan.tolerance, mm)},
                 {"corridor_mm", scaled(plan.corridor, mm)},
                 {"tumour", nullptr}};
    if (plan.tumour) {
        node["tumour"] = {{"level", plan.tumour->level},
                          {"sector", sector_name(plan.tumour->sector)},
                          {"depth_mm", scaled(plan.tumour->depth, mm)},
                          {"length_mm", scaled(plan.tumour->length, mm)}};
    }
    return node;
}
SpecimenPlan specimen_from(const Json& node) {
    SpecimenPlan plan;
    plan.levels = node.at("levels").get<int>();
    plan.line = node.at("line_mm").get<double>() / mm;
    // Reports before version 4 asked for the whole line.
    plan.asked = node.contains("asked_mm") ? node.at("asked_mm").get<double>() / mm : plan.asked_length();
    plan.spacing = node.at("spacing_mm").get<double>() / mm;
    plan.plane = node.at("plane_mm").get<double>() / mm;
    plan.areolar = node.at("areolar_mm").get<double>() / mm;
    plan.fat = node.at("muscularis_mm").get<double>() / mm;
    plan.tolerance = node.at("tolerance_mm").get<double>() / mm;
    plan.corridor = node.at("corridor_mm").get<double>() / mm;
    const Json& tumour = node.at("tumour");
    if (!tumour.is_null())
        plan.tumour =
            Tumour{tumour.at("level").get<int>(), sector_from(tumour.at("sector")),
                   tumour.at("depth_mm").get<double>() / mm, tumour.at("length_mm").get<double>() / mm};
    return plan;
}

/// Reports of versions 1 and 2 have one reason, and no shares of fat.
void read_reasons(const Json& root, PathologyReport& report) {
    using R = GradeReason;
    const auto reason = [](const Json& node) {
        return named(node,
                     {R::nothing_cut, R::undivided, R::intact, R::defect, R::fat, R::coning, R::muscularis,
                      R::bulk_loss, R::deep_coning, R::perforation},
                     grade_reason_name);
    };
    report.reasons.clear();
    if (report.version < 3) {
        const Json& one = root.at("grade_reason");
        report.reasons =
            one == "defect_and_coning" ? std::vector<R>{R::defect, R::coning} : std::vector<R>{reason(one)};
        return;
    }
    for (const Json& node : root.at("grade_reasons")) report.reasons.push_back(reason(node));
    if (report.reasons.empty()) throw Json::other_error::create(501, "/grade_reasons is empty", &root);
    report.fat_share = root.at("fat_share_percent").get<double>() / percent;
    report.median_fat_depth = root.at("median_fat_depth_mm").get<double>() / mm;
    report.perforated = root.at("perforated").get<bool>();
}

}  // namespace

std::string pathology_json(const PathologyReport& report) {
    Json findings = Json::array(), sectors = Json::array(), defects = Json::array();
    for (const SectorFinding& finding : report.findings) findings.push_back(finding_json(finding));
    for (const SectorFinding& finding : report.sectors) sectors.push_back(finding_json(finding));
    for (const Defect& defect : report.defects) {
        defects.push_back({{"level", defect.level},
                           {"from_mm", scaled(defect.from, mm)},
                           {"to_mm", scaled(defect.to, mm)},
                           {"depth_mm", scaled(defect.depth, mm)},
                           {"muscularis", defect.muscularis},
                           {"when_s", interval_json(defect.when)}});
    }
    Json reason_names = Json::array();
    for (const GradeReason reason : report.reasons) reason_names.push_back(grade_reason_name(reason));
    const Json document = {
        {"version", report.version},
        {"specimen", specimen_json(report.plan)},
        {"divided_percent", scaled(report.divided, percent)},
        {"plane", plane_json(report.plane)},
        {"findings", std::move(findings)},
        {"sectors", std::move(sectors)},
        {"defects", std::move(defects)},
        {"deepest_defect_mm", scaled(report.deepest_defect, mm)},
        {"coning_mm", scaled(report.coning, mm)},
        {"tme_grade", report.grade ? Json(*report.grade) : Json(nullptr)},
        {"grade_reasons", std::move(reason_names)},
        {"fat_share_percent", scaled(report.fat_share, percent)},
        {"median_fat_depth_mm", scaled(report.median_fat_depth, mm)},
        {"perforated", report.perforated},
        {"crm", margin_json(report.circumferential)},
        {"drm", margin_json(report.distal)},
        {"lowest_level", report.lowest_level < 0 ? Json(nullptr) : Json(report.lowest_level)},
        {"transected", false}};
    return document.dump();
}

PathologyReport parse_pathology(const std::string& text, const std::string& file) {
    try {
        const Json root = Json::parse(text);
        PathologyReport report;
        report.version = root.at("version").get<int>();
        report.plan = specimen_from(root.at("specimen"));
        report.divided = root.at("divided_percent").get<double>() / percent;
        report.plane = plane_from(root.at("plane"));
        for (const Json& node : root.at("findings")) report.findings.push_back(finding_from(node));
        for (std::size_t i = 0; i < report.sectors.size(); ++i)
            report.sectors[i] = finding_from(root.at("sectors").at(i));
        for (const Json& node : root.at("defects"))
            report.defects.push_back({node.at("level").get<int>(), node.at("from_mm").get<double>() / mm,
                                      node.at("to_mm").get<double>() / mm,
                                      node.at("depth_mm").get<double>() / mm,
                                      node.at("muscularis").get<bool>(), interval_from(node.at("when_s"))});
        report.deepest_defect = root.at("deepest_defect_mm").get<double>() / mm;
        report.coning = unscaled(root.at("coning_mm"), mm);
        if (!root.at("tme_grade").is_null()) report.grade = root.at("tme_grade").get<int>();
        read_reasons(root, report);
        report.circumferential = margin_from(root.at("crm"));
        report.distal = margin_from(root.at("drm"));
        report.lowest_level = root.at("lowest_level").is_null() ? -1 : root.at("lowest_level").get<int>();
        return report;
    } catch (const nlohmann::json::exception& error) {
        throw InputError(file, "/", error.what(),
                         QT_TRANSLATE_NOOP("errors", "give a pathology report as the program writes it"));
    }
}

}  // namespace fulcrum
