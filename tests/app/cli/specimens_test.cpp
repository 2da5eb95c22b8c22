// SPDX-License-Identifier: GPL-3.0-or-later
// Specimens of C4 made by hand, each as a trace and events that the command line reads: the grade and the
// margin that the definitions give (docs/FORMATS.md, Pathology).
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/services/program.h"
#include "assessment/pathology/pathology.h"
#include "assessment/task/specimen_plan.h"
#include "database/scoring/loaded_task.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

constexpr double mm = 1e-3;
/// Height of the cut above the sacrum's fascia (m) at a place of a level, 0 to 1 from the patient's right; or
/// nothing where the tissue is left.
using Course = std::function<std::optional<double>(int level, double place)>;

struct Specimen {
    const char* name;
    Course height;
    int grade;           ///< 0: not gradable
    const char* reason;  ///< the first
    const char* margin;  ///< "positive", "negative" or why there is none
    bool perforated = false;
};

class Specimens : public ::testing::Test {
  protected:
    Specimens()
        : loaded_(load_task_and_scene("C4")), plan_(*make_specimen_plan(loaded_.scene, loaded_.task)) {}

    nlohmann::json report_on(const Specimen& specimen) const {
        std::ofstream(trace_) << "t\ns\n0\n100\n";
        std::ofstream out(events_);
        out << "t,event,hand,tissue,value,detail\ns,-,-,-,event,event\n0,attempt_begin,,,0,7\n";
        double t = 1;
        for (int level = 0; level < plan_.levels; ++level) {
            bool cutting = false;
            constexpr int pieces = 280;  // of 0.2 mm
            for (int i = 0; i <= pieces; ++i, t += 0.01) {
                // Just inside the level's ends: its rims are no surface of the specimen.
                const double place = std::min(std::max(static_cast<double>(i) / pieces, 1e-4), 1 - 1e-4);
                const auto height = specimen.height(level, place);
                const char* event = !height   ? (cutting ? "cut_end" : nullptr)
                                    : cutting ? "cut_advance"
                                              : "cut_begin";
                if (event != nullptr)
                    out << t << ',' << event << ",right,," << (level + place) * plan_.line << ','
                        << std::lround((plan_.plane - height.value_or(plan_.plane)) * 1e6) << '\n';
                cutting = height.has_value();
            }
            if (cutting) out << t << ",cut_end,right,," << (level + 1 - 1e-4) * plan_.line << ",0\n";
        }
        if (specimen.perforated) out << t << ",perforation,left,,12,0\n";
        out << t << ",completed,,,0,0\n";
        out.close();
        std::ostringstream text;
        std::streambuf* const before = std::cout.rdbuf(text.rdbuf());
        const int status = run_command({"metrics", trace_, "--events", events_, "--task", "C4", "--json"});
        std::cout.rdbuf(before);
        EXPECT_EQ(status, 0);
        return nlohmann::json::parse(text.str());
    }

    void expect(const Specimen& specimen) const {
        const nlohmann::json document = report_on(specimen);
        const nlohmann::json& report = document["pathology"];
        EXPECT_EQ(report["tme_grade"].is_null() ? 0 : report["tme_grade"].get<int>(), specimen.grade)
            << specimen.name << report.dump(1);
        EXPECT_EQ(report["grade_reasons"][0], specimen.reason) << specimen.name;
        const nlohmann::json& margin = report["crm"];
        const std::string found = margin["mm"].is_null() ? margin["absent_because"].get<std::string>()
                                  : margin["mm"].get<double>() <= 1.0 + 1e-9 ? "positive"
                                                                             : "negative";
        EXPECT_EQ(found, specimen.margin) << specimen.name << ' ' << margin.dump();
        for (const auto& row : document["metrics"]) {
            if (row["id"] != "tme_grade") continue;
            EXPECT_EQ(row["value"].is_null(), specimen.grade == 0) << specimen.name;
            if (specimen.grade != 0) {
                EXPECT_EQ(row["value"].get<int>(), specimen.grade) << specimen.name;
            }
        }
    }

    double in_plane() const { return plan_.plane; }
    /// So deep in the fat.
    double fat(double depth) const { return plan_.areolar + depth; }
    /// With so much tissue left between the cut and the tumour.
    double margin(double left) const { return plan_.fat - plan_.tumour->depth - left; }
    bool at_tumour(int level, double place) const {
        return level == plan_.tumour->level && place > 1.0 / 3 && place < 2.0 / 3;
    }

    fulcrum::test::OwnFolder folder_;
    LoadedTask loaded_;
    SpecimenPlan plan_;
    std::string trace_ = (folder_ / "trace.csv").string(), events_ = (folder_ / "events.csv").string();
};

TEST_F(Specimens, HaveTheGradeThatTheDefinitionsGive) {
    const double whole = in_plane();
    const auto everywhere = [](double height) {
        return [height](int, double) { return std::optional<double>(height); };
    };
    const auto notch = [&](double depth, double width) {
        return [=](int level, double place) {
            return std::optional<double>(level == 2 && place < width ? fat(depth) : whole);
        };
    };
    const auto coning = [&](double inwards) {
        return [=](int level, double) {
            return std::optional<double>(whole + inwards * level / (plan_.levels - 1));
        };
    };
    const auto up_to = [&](int levels, double share) {
        return [=](int level, double place) {
            return level < levels || (level == levels && place <= share) ? std::optional<double>(whole)
                                                                         : std::nullopt;
        };
    };
    const auto near_tumour = [&](double left) {
        return [=](int level, double place) {
            return std::optional<double>(at_tumour(level, place) ? margin(left) : whole);
        };
    };
    const double wall = plan_.fat - plan_.areolar;
    const Specimen specimens[] = {
        {"in the plane", everywhere(whole), 3, "intact", "negative"},
        {"half a millimetre too deep", everywhere(whole - 0.5 * mm), 3, "intact", "negative"},
        {"two millimetres too deep", everywhere(whole - 2 * mm), 3, "intact", "negative"},
        {"in the areolar layer", everywhere(whole + 2 * mm), 3, "intact", "negative"},
        {"a defect of 4.9 mm", notch(4.9 * mm, 0.1), 3, "intact", "negative"},
        {"a defect of 5 mm", notch(5 * mm, 0.1), 3, "intact", "negative"},
        {"a defect of 5.1 mm", notch(5.1 * mm, 0.1), 2, "defect", "negative"},
        {"a wide defect of 5.1 mm", notch(5.1 * mm, 0.7), 2, "defect", "negative"},
        {"shallow in the fat for a tenth", notch(2.5 * mm, 0.4), 3, "intact", "negative"},
        {"2.5 mm in the fat for a quarter", notch(2.5 * mm, 1.0), 2, "fat", "negative"},
        {"2 mm in the fat for a quarter", notch(2 * mm, 1.0), 3, "intact", "negative"},
        {"coning of 2.9 mm", coning(2.9 * mm), 3, "intact", "negative"},
        {"coning of 3.2 mm", coning(3.2 * mm), 2, "coning", "negative"},
        {"coning of 5.9 mm", coning(5.9 * mm), 2, "fat", "negative"},
        {"coning of 6.2 mm", coning(6.2 * mm), 1, "deep_coning", "negative"},
        {"down to the muscularis", notch(wall, 0.1), 1, "muscularis", "negative"},
        {"2 mm above the muscularis", notch(wall - 2 * mm, 0.1), 2, "defect", "negative"},
        {"bulk loss", everywhere(fat(8.1 * mm)), 1, "bulk_loss", "positive"},
        {"a perforated bowel", everywhere(whole), 1, "perforation", "negative", true},
        {"nothing cut", [](int, double) { return std::optional<double>(); }, 0, "nothing_cut", "not_divided"},
        {"one level", up_to(1, 0), 0, "undivided", "not_divided"},
        {"94 % divided", up_to(3, 0.76), 0, "undivided", "negative"},
        {"96 % divided", up_to(3, 0.84), 3, "intact", "negative"},
        {"a perforated bowel, half divided", up_to(2, 0), 0, "undivided", "negative", true},
        {"1.1 mm from the tumour", near_tumour(1.1 * mm), 3, "intact", "negative"},
        {"1.0 mm from the tumour", near_tumour(1.0 * mm), 3, "intact", "positive"},
        {"0.9 mm from the tumour", near_tumour(0.9 * mm), 2, "defect", "positive"},
        {"through the tumour", near_tumour(-1 * mm), 2, "defect", "positive"},
        {"the tumour's sector left",
         [&](int level, double place) {
             return at_tumour(level, place) ? std::nullopt : std::optional<double>(whole);
         },
         0, "undivided", "not_divided"},
    };
    EXPECT_GE(std::size(specimens), 25U);
    for (const Specimen& specimen : specimens) expect(specimen);
}

}  // namespace
}  // namespace fulcrum::app
