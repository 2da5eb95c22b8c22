// SPDX-License-Identifier: Apache-2.0
// A sacral hollow with veins and nerves, optionally B2's sheet far in front of it, and hands at poses set by
// the test. No haptic loop: tools are set directly.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim_core/world/parts/sheet/sheet_part.h"
#include "sim_core/world/parts/structures/structures_part.h"
#include "tests/support/support.h"

namespace fulcrum::test {

/// B2's sheet in the air, and elsewhere a sacral hollow with structures.
inline Scene structures_scene() {
    Scene scene = load_scene(source_path("assets/scenes/b2_areolar.json"));
    scene.structures = StructuresSpec();
    for (const char* label : {"fascia", "nerve", "vein"}) {
        TissueSpec tissue;
        tissue.label = label;
        scene.tissues.push_back(tissue);
    }
    for (InstrumentSpec& instrument : scene.instruments) {
        if (instrument.hand != Hand::right) continue;
        instrument.kind = InstrumentKind::hook;
        instrument.exchange = {InstrumentKind::hook, InstrumentKind::suction, InstrumentKind::clip_applier,
                               InstrumentKind::harmonic, InstrumentKind::scissors};
        instrument.jaw_length = 0.014;
    }
    return scene;
}
inline TissueSpec& fascia(Scene& scene) {
    return scene.tissues[static_cast<std::size_t>(scene.tissue_index("fascia"))];
}

/// The hollow of C4, with a smooth fascia.
inline RectumParameters hollow() {
    RectumParameters rectum;
    rectum.curve = {Vector3(0, -0.07, 0.079), 0.123, -0.2617993877991494, 0.015, 0.018};
    rectum.unevenness = 0;
    return rectum;
}

class StructuresStage {
  public:
    explicit StructuresStage(const Scene& given = structures_scene(), bool with_sheet = false,
                             std::uint64_t seed = 5)
        : scene(given),
          wall(presacral_wall(hollow().curve, hollow().promontory)),
          felt(make_presacral_wall(hollow()), FreeSide::front),
          sheet(with_sheet ? std::make_unique<SheetPart>(scene, scene.step_period()) : nullptr),
          part(scene, wall, felt, sheet.get(), seed),
          outputs(static_cast<std::size_t>(scene.ticks_per_step)) {
        if (sheet) sheet->size_snapshot(snapshot);
        part.size_snapshot(snapshot);
        for (ToolKinematics& t : tool) {
            t.present = t.inside = true;
            t.jaw_angle = 0.8;
            t.tip = away();
        }
        part.fill_snapshot(snapshot);
    }

    void step() {
        for (TickOutput& output : outputs) {
            for (int h = 0; h < hand_count; ++h) output.contact[h].tool = tool[h];
        }
        tick += static_cast<std::uint32_t>(outputs.size());
        if (sheet) {
            SheetAction actions[hand_count];
            for (int h = 0; h < hand_count; ++h) {
                const HeldTool held = part.held(h, tool[h]);
                actions[h].instrument = held.instrument;
                actions[h].tool = held.tool;
                actions[h].energised = held.energised;
            }
            sheet->step(actions, tick, scene.step_period());
            snapshot.event_count = 0;
            sheet->fill_snapshot(snapshot);
        }
        part.step(outputs.data(), outputs.size(), scene.step_period());
        part.fill_snapshot(snapshot);
    }
    void run(double seconds) {
        for (int i = 0; i < static_cast<int>(std::lround(seconds / scene.step_period())); ++i) step();
    }
    void go(int hand, const Vector3& to, double speed = 0.05) {
        const Vector3 from = tool[hand].tip;
        const int count =
            std::max(1, static_cast<int>(std::ceil((to - from).norm() / (speed * scene.step_period()))));
        for (int i = 1; i <= count; ++i) {
            tool[hand].tip = from + (static_cast<double>(i) / count) * (to - from);
            step();
        }
    }
    void press(int hand, std::uint16_t mask, bool on) {
        tool[hand].buttons =
            static_cast<std::uint16_t>(on ? tool[hand].buttons | mask : tool[hand].buttons & ~mask);
    }
    void take(int hand, InstrumentKind kind) {
        tool[hand].tip = away();
        for (int i = 0; i < 6 && field().tools[hand].kind != kind; ++i) {
            press(hand, button_exchange, true);
            step();
            press(hand, button_exchange, false);
            run(part.field().hand(hand).exchange_left + 0.01);
        }
    }
    double radius(int hand) const { return scene.instrument(static_cast<Hand>(hand))->tip_radius; }
    /// A position clear of everything.
    static Vector3 away() { return Vector3(0, 0.01, 0.05); }
    /// Direction towards the rectum from a position on the wall.
    Vector3 out(const Vector3& place) const { return felt.closest(place + Vector3(0, 0, 1e-4), 0.01).normal; }
    /// Tip position that is `depth` deep in the wall at a position on it.
    Vector3 pressed(int hand, const Vector3& place, double depth) const {
        return place + (radius(hand) - depth) * out(place);
    }
    /// A position on the wall over a vein, by the fraction of its length. At 0.4 of a long one there is no
    /// rung nearby.
    Vector3 over_vein(std::size_t vein, double share) const {
        const std::vector<Vector3>& line = part.layout().veins[vein].line;
        return line[static_cast<std::size_t>(std::lround(share * static_cast<double>(line.size() - 1)))];
    }
    const FieldView& field() const { return snapshot.field[0]; }
    const StructuresView& structures() const { return snapshot.structures; }
    int opened() const {
        int sum = 0;
        for (const OutletView& outlet : field().outlets) sum += outlet.opened ? 1 : 0;
        return sum;
    }

    Scene scene;
    FieldWall wall;
    CavityModel felt;
    std::unique_ptr<SheetPart> sheet;
    StructuresPart part;
    WorldSnapshot snapshot;
    std::vector<TickOutput> outputs;
    ToolKinematics tool[hand_count];
    std::uint32_t tick = 0;
};

}  // namespace fulcrum::test
