// SPDX-License-Identifier: Apache-2.0
// A field as a whole: its heat patches, its step after the hands, what is seen of it.
#include "sim_core/world/field/operative_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double bed_depth = 0.003;         // m of the bed that a patch stands for
constexpr double gas_transfer = 10;         // W/(m2 K), still gas
constexpr double blood_per_tissue = 8e-7;   // m3/(s kg), about 50 mL/min/kg; provisional
constexpr double blood_heat = 3.8e6;        // J/(m3 K)
constexpr double least_gap = 0.001;         // m of tissue between a nerve and the bed
constexpr double wall_reach = 0.02;         // m, beyond it a wall is far
constexpr double visible_flow = 1e-6 / 60;  // m3/s: 1 mL/min, from where an opening counts as bleeding

using namespace field_rules;

}  // namespace

std::int32_t FieldHeat::patch(double volume, double surface) {
    const double mass = spec_.density * volume;
    model_.patches.push_back({mass * spec_.specific_heat,
                              mass * blood_per_tissue * blood_heat + gas_transfer * surface,
                              spec_.water_share * mass});
    return static_cast<std::int32_t>(model_.patches.size()) - 1;
}

std::int32_t FieldHeat::link(std::int32_t a, std::int32_t b, double area, double distance) {
    model_.links.push_back({a, b, spec_.conductivity * area / distance});
    return static_cast<std::int32_t>(model_.links.size()) - 1;
}

std::size_t FieldHeat::bed(const FieldBed& bed) {
    const std::size_t first = model_.patches.size();
    const PoolModel& pool = bed.pool;
    for (int row = 0; row < pool.rows; ++row) {
        for (int column = 0; column < pool.columns; ++column) {
            const std::int32_t here = patch(pool.cell * pool.cell * bed_depth, pool.cell * pool.cell);
            if (column > 0) link(here - 1, here, pool.cell * bed_depth, pool.cell);
            if (row > 0) link(here - pool.columns, here, pool.cell * bed_depth, pool.cell);
        }
    }
    return first;
}

std::size_t FieldHeat::nerve(const std::vector<Vector3>& line, const FieldBed& bed, std::size_t first_bed,
                             const std::function<double(const Vector3&)>& above) {
    const std::size_t first = model_.patches.size();
    const double piece = (line.back() - line.front()).norm() / static_cast<double>(line.size() - 1);
    const double round = pi * spec_.nerve_radius * spec_.nerve_radius;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const std::int32_t here = patch(round * piece, 2 * pi * spec_.nerve_radius * piece);
        if (i > 0) link(here - 1, here, round, piece);
        link(here, static_cast<std::int32_t>(first_bed + bed.cell(line[i])), 2 * spec_.nerve_radius * piece,
             std::max(least_gap, above(line[i])));
    }
    return first;
}

OperativeField::OperativeField(const Scene& scene, const FieldSpec& spec, FieldModel model,
                               std::size_t outlets)
    : spec_(spec), model_(std::move(model)) {
    heat_ = make_heat_state(model_.heat);
    inputs_ = make_heat_inputs(model_.heat);
    scratch_ = make_heat_scratch(model_.heat);
    pool_ = make_pool_state(model_.bed.pool);
    outlets_.resize(outlets);
    nerve_divided_.assign(model_.nerves.size(), 0);
    clips_left_ = spec_.clips;
    for (const InstrumentSpec& instrument : scene.instruments) {
        FieldHand& hand = hands_[static_cast<std::size_t>(instrument.hand)];
        hand.instrument = std::make_shared<const InstrumentSpec>(instrument);
        hand.kinds[0] = instrument.kind;
        hand.kind_count =
            std::clamp(static_cast<int>(instrument.exchange.size()), 1, static_cast<int>(hand.kinds.size()));
        for (std::size_t i = 0; i < instrument.exchange.size() && i < hand.kinds.size(); ++i)
            hand.kinds[i] = instrument.exchange[i];
        for (std::size_t i = 0; i < hand.kinds.size(); ++i) {
            InstrumentSpec& one = instruments_[static_cast<std::size_t>(instrument.hand)][i];
            one = instrument;
            one.kind = hand.kinds[i];
        }
    }
}

double OperativeField::above_bed(const Vector3& place) const noexcept {
    if (model_.wall == nullptr) return place.z() - model_.bed.ground(place);
    const CavityPoint nearest = model_.wall->closest(place, wall_reach);
    return nearest.triangle >= 0 ? nearest.distance : 1.0;
}

void OperativeField::begin_step() noexcept {
    std::fill(inputs_.power.begin(), inputs_.power.end(), 0.0);
    std::fill(inputs_.contact.begin(), inputs_.contact.end(), 0.0);
    std::fill(inputs_.contact_rise.begin(), inputs_.contact_rise.end(), 0.0);
    suction_ = false;
}

HeatReport OperativeField::step_heat(double dt) noexcept {
    const HeatReport report = fulcrum::step_heat(model_.heat, inputs_, dt, heat_, scratch_);
    for (FieldHand& hand : hands_) {
        if (hand.instrument == nullptr || !gives_energy(hand.kind())) continue;
        const EnergyToolModel& tool = tool_model(hand);
        double given = 0;
        for (int i = 0; i < hand.touched_count; ++i) {
            const auto patch = static_cast<std::size_t>(hand.touched[static_cast<std::size_t>(i)]);
            given += tool.blade_contact * (hand.blade.rise - heat_.rise[patch]) * dt;
        }
        step_blade(tool, hand.active, given, dt, hand.blade);
    }
    return report;
}

void OperativeField::seal(double& share, double degrees, double dt) const noexcept {
    const double hot =
        std::clamp((degrees - coagulation_start) / (coagulation_full - coagulation_start), 0.0, 1.0);
    share = 1 - (1 - share) * math::exp(-hot * dt / spec_.seal_time);
}

void OperativeField::seal_outlets(double dt) noexcept {
    for (FieldOutlet& outlet : outlets_) {
        if (outlet.exposed) seal(outlet.bleed.sealed, temperature(outlet.patch), dt);
    }
}

void OperativeField::bleed(double dt) noexcept {
    for (FieldOutlet& outlet : outlets_) {
        if (!outlet.opened) continue;
        const double lost =
            step_bleed(model_.vessels[static_cast<std::size_t>(outlet.vessel)], dt, outlet.bleed);
        pour(model_.bed.pool, model_.bed.column(outlet.position), model_.bed.row(outlet.position), lost,
             pool_);
    }
    step_pool(model_.bed.pool, dt, pool_);
}

void OperativeField::end_step(double steam, double dt) noexcept {
    step_smoke(smoke_model_, steam, suction_, dt, smoke_);
}

void OperativeField::size_view(FieldView& view) const {
    view.outlets.resize(outlets_.size());
    view.nerves.resize(model_.nerves.size());
    for (std::size_t n = 0; n < view.nerves.size(); ++n) {
        view.nerves[n].line = model_.nerves[n].line;
        view.nerves[n].dose.assign(view.nerves[n].line.size(), 0.0F);
    }
    view.nerve_radius = spec_.nerve_radius;
    const FieldBed& bed = model_.bed;
    view.columns = bed.pool.columns;
    view.rows = bed.pool.rows;
    view.cell = bed.pool.cell;
    view.corner = bed.corner;
    for (const double height : bed.pool.ground) view.ground.push_back(static_cast<float>(height));
    view.blood.assign(view.ground.size(), 0.0F);
    view.bed_dose.assign(view.ground.size(), 0.0F);
}

void OperativeField::fill_view(FieldView& view) const noexcept {
    const FieldBed& bed = model_.bed;
    view.lost = 0;
    for (std::size_t i = 0; i < outlets_.size(); ++i) {
        const FieldOutlet& outlet = outlets_[i];
        OutletView& seen = view.outlets[i];
        seen.position = outlet.position;
        const double flow =
            outlet.opened ? bleed_flow(model_.vessels[static_cast<std::size_t>(outlet.vessel)], outlet.bleed)
                          : 0.0;
        seen.flow = flow >= visible_flow ? flow : 0.0;
        seen.lost = outlet.bleed.lost;
        seen.blood_depth = static_cast<float>(std::max(
            0.0, bed.ground(seen.position) + pool_.depth[bed.cell(seen.position)] - seen.position.z()));
        seen.opened = outlet.opened;
        seen.clipped = outlet.bleed.clipped;
        seen.injured = outlet.injured;
        view.lost += outlet.bleed.lost;
    }
    view.removed = pool_.removed;
    for (int number = 0; number < hand_count; ++number) {
        const FieldHand& from = hand(number);
        HandToolView& seen = view.tools[number];
        seen.kind = from.kind();
        seen.index = from.index;
        seen.exchange_left = static_cast<float>(from.exchange_left);
        seen.active = from.active;
        seen.target = from.target;
        seen.nerve_distance = static_cast<float>(from.nerve_distance);
        seen.blade = static_cast<float>(model_.heat.body_temperature + from.blade.rise);
        seen.clips_left = clips_left_;
        seen.clips_fired = from.clips_fired;
        seen.last_clip_outlet = from.last_clip_outlet;
        seen.last_clip_distance = static_cast<float>(from.last_clip_distance);
    }
    double worst = 0, lateral = 0;
    std::size_t dead = 0;
    for (std::size_t n = 0; n < model_.nerves.size(); ++n) {
        NerveView& seen = view.nerves[n];
        for (std::size_t i = 0; i < seen.dose.size(); ++i) {
            const double dose = heat_.dose[model_.nerves[n].first + i];
            seen.dose[i] = static_cast<float>(dose);
            worst = std::max(worst, dose);
        }
        seen.divided = nerve_divided_[n] != 0;
    }
    for (std::size_t i = 0; i < view.blood.size(); ++i) {
        view.blood[i] = static_cast<float>(pool_.depth[i]);
        const double dose = heat_.dose[model_.first_bed + i];
        view.bed_dose[i] = static_cast<float>(dose);
        lateral = std::max(lateral, dose);
        dead += dose >= lethal_dose ? 1 : 0;
    }
    view.worst_nerve_dose = worst;
    view.worst_bed_dose = lateral;
    view.lateral_dose = std::max(worst, lateral);
    view.lateral_area = static_cast<double>(dead) * bed.pool.cell * bed.pool.cell;
    view.smoke = 1 - transmission(smoke_model_, smoke_);
    view.heat_given = heat_.given;
}

std::size_t OperativeField::model_bytes() const {
    const std::size_t patches = model_.heat.patches.size();
    return patches * (sizeof(HeatPatch) + 9 * sizeof(double)) + model_.heat.links.size() * sizeof(HeatLink) +
           pool_.depth.size() * sizeof(double);
}

}  // namespace fulcrum
