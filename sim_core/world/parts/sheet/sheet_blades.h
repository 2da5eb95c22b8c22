// SPDX-License-Identifier: Apache-2.0
// Blades in the sheet: Eqs. 6 and 7 (blade_law.h), the steps of a cut and what is reported of it.
#pragma once

#include <array>

#include "sim_core/world/parts/sheet/fibre_parting.h"
#include "sim_core/world/parts/sheet/sheet_body.h"

namespace fulcrum {

class SheetBlades {
  public:
    SheetBlades(SheetBody& sheet, FibreParting& fibres) : sheet_(sheet), fibres_(fibres) {}
    /// After the sheet is solved: what a hand's blade does in it.
    void follow(int hand, const SheetAction& action, std::uint32_t tick) noexcept;

  private:
    /// Tissue under a point of a blade, nearest first: a sheet may lie in folds, of which the blade divides
    /// one.
    struct UnderBlade {
        struct Layer {
            Vector3 rest = Vector3::Zero();
            std::int32_t root = -1;
            double away = 0;  ///< along the normal, of twice the blade's reach
        };
        static constexpr std::size_t capacity = 3;
        std::size_t count = 0;
        double across = 0;  ///< m along the surface, from the point to what the blade's width alone reaches
        std::array<Layer, capacity> layers;
    };
    /// A blade's step before it divides anything.
    struct BladeTrack {
        static constexpr std::size_t capacity = SheetBody::track_capacity;
        std::size_t count = 0;
        double spacing = 0;  ///< m between its samples; the first lies where the step begins
        std::array<UnderBlade, capacity> samples;
    };
    struct Follow;  // the blade law's tissue
    void enter(int hand, const Vector3& here, const Vector3& along, std::uint32_t tick) noexcept;
    void advance(int hand, const Vector3& way, std::uint32_t tick) noexcept;
    void drift(int hand, std::uint32_t tick) noexcept;
    Vector3 begin_of_way(const SheetPlace& where, const Vector3& behind,
                         const Vector3& normal) const noexcept;
    Vector3 keep_off_wall(const SheetPlace& where, const Vector3& way) const noexcept;
    /// What lies within a depth (m) along a normal, either side.
    void find_under(const Vector3& point, const Vector3& normal, double depth,
                    UnderBlade& found) const noexcept;
    void add_under(const SheetPlace& where, double away, UnderBlade& found) const noexcept;
    void follow_track(const BladeStep& blade, BladeTrack& track) const noexcept;
    static bool over_tissue(const UnderBlade& sample) noexcept;
    bool meets_tissue(const SheetPlace& from, const BladeTrack& track) const noexcept;
    bool joined(const UnderBlade::Layer& a, const UnderBlade::Layer& b) const noexcept;
    const UnderBlade::Layer* divided_of(const UnderBlade& sample) const noexcept;
    void report_track(int hand, const BladeTrack& track, double traction, std::uint32_t tick) noexcept;
    void report_cut(int hand, const Vector3& reached, double traction, std::uint32_t tick) noexcept;

    SheetBody& sheet_;
    FibreParting& fibres_;
};

}  // namespace fulcrum
