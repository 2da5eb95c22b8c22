// SPDX-License-Identifier: Apache-2.0
// One complete blade step through a sheet: surface, invariants, fragments, nodes and springs, positions.
#include <cmath>
#include <memory>

#include "sim_core/lab/bench.h"
#include "sim_core/world/parts/sheet/sheet_part.h"

namespace fulcrum::lab {
namespace {

constexpr double step_length = 0.002;  // m
constexpr int lines = 14, steps_a_line = 54;

Scene sheet_scene() {
    Scene scene;
    scene.id = "cut_full";
    TissueSpec tissue;
    tissue.label = "areolar";
    tissue.cutting = CuttingSpec();
    scene.tissues.push_back(tissue);
    scene.sheet = SheetSpec();
    scene.sheet->weight = 0;
    scene.sheet->spacing = 0.002;
    return scene;
}

struct Blade {
    Scene scene = sheet_scene();
    SheetPart sheet{scene, scene.step_period()};
    SheetPart::State start = sheet.state();
    CutState uncut = sheet.surface().state();
    int next = 0;
    /// Line by line across the sheet, one stroke each; a new sheet when it is used up.
    void cut() {
        const int line = next / steps_a_line, along = next % steps_a_line;
        BladeStep blade;
        const double y = (line + 0.5) / lines - 0.5;
        blade.from = scene.sheet->centre + (along * step_length - 0.054 - 0.0003) * scene.sheet->along +
                     y * 0.9 * scene.sheet->width * scene.sheet->across;
        blade.to = blade.from + (step_length + 0.0003) * scene.sheet->along;
        blade.width = scene.sheet->blade_width;
        blade.depth = 0.01;
        blade.root = root;
        const CutReport report = sheet.cut(blade);
        if (report.root >= 0) root = report.root;
        ++next;
    }
    void aim() {
        if (next == lines * steps_a_line) {
            sheet.restore(start, uncut);
            next = 0;
        }
        if (next % steps_a_line != 0) return;
        const double y = (next / steps_a_line + 0.5) / lines - 0.5;
        const Vector3 first = scene.sheet->centre - 0.054 * scene.sheet->along +
                              y * 0.9 * scene.sheet->width * scene.sheet->across;
        root = sheet.surface().nearest_root(first, sheet.state().positions.data());
    }
    std::int32_t root = -1;
};

}  // namespace

void add_sheet_workloads(std::vector<Workload>& workloads) {
    Workload workload;
    workload.name = "cut_full";
    workload.budget_mg = 100;
    workload.worst_budget_mg = 700;
    workload.warm_up = 20;
    workload.samples = 700;
    workload.prepare = [] {
        const auto blade = std::make_shared<Blade>();
        Workload::Prepared prepared;
        prepared.step = [blade] { blade->cut(); };
        prepared.between = [blade] { blade->aim(); };
        prepared.error = [blade]() -> std::optional<double> {
            const CutMesh& surface = blade->sheet.surface();
            return std::abs(surface.area_visible() + surface.area_removed() - surface.area_before()) /
                   surface.area_before();
        };
        prepared.error_unit = "rest area before - after - removed, of before";
        prepared.bytes = blade->sheet.bytes();
        return prepared;
    };
    workloads.push_back(workload);
}

}  // namespace fulcrum::lab
