// SPDX-License-Identifier: Apache-2.0
// Events of bands, vessels and nerves: activations with their conditions, divisions, bleeding, clips, thermal
// spread. Inactive without Scene::bands and Scene::structures.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "assessment/task/monitor.h"

namespace fulcrum {

/// One attempt's bands. Allocates nothing after construction, never throws.
class BandMonitor {
  public:
    explicit BandMonitor(const Scene& scene);
    /// One tick that is not paused: what was in view while energy was on.
    void tick(const TickSample& sample) noexcept;
    /// After the step, with its last tick.
    void step(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept;
    /// Before the end of the attempt: ends open activations and reports the sums once more.
    void finish(std::uint32_t tick, EventSink& sink) noexcept;

    /// Bands divided with an instrument. A band that was torn is not divided and never will be.
    int divided() const noexcept { return divided_; }
    int torn() const noexcept { return torn_; }
    /// Vessels of bands that are divided or torn and do not bleed.
    int dry() const noexcept { return dry_; }
    double lost_ml() const noexcept { return lost_ml_; }
    int clips_left() const noexcept { return clips_left_; }
    /// A hand fired a clip in the last step.
    bool clipped(int hand) const noexcept { return clipped_[static_cast<std::size_t>(hand)]; }

    /// All that changes.
    template <typename Visit>
    void fields(Visit&& visit) {
        visit(spans_, clips_fired_, tool_index_, band_parted_, pulled_by_, bleeding_, injured_, nerve_heated_,
              nerve_divided_, outlet_ml_, divided_, torn_, dry_, clips_left_, lost_ml_, told_ml_, dose_,
              told_dose_, area_, told_area_, told_dose_tick_, told_area_tick_, dose_tissue_);
    }

  private:
    /// An activation under way.
    struct Span {
        bool on = false, seen_in_view = true;
        bool spent = false;         ///< it ended under power, which has reached nothing since then
        Activation held;            ///< throughout
        double least_distance = 1;  ///< m
        std::int8_t tissue = -1;
    };
    void step_hand(int hand, const FieldView& view, std::uint32_t tick, EventSink& sink) noexcept;
    /// Notes which hand pulls each band most.
    void watch_traction(const WorldSnapshot& world) noexcept;
    void step_bands(const BandsView& view, std::uint32_t tick, EventSink& sink) noexcept;
    void step_nerves(const FieldView& view, std::uint32_t tick, EventSink& sink) noexcept;
    void step_outlets(const FieldView& view, std::uint32_t tick, EventSink& sink) noexcept;
    void end_activation(int hand, std::uint32_t tick, EventSink& sink) noexcept;
    void tell_loss(std::uint32_t tick, EventSink& sink) noexcept;
    void tell_dose(std::uint32_t tick, EventSink& sink) noexcept;
    void tell_area(std::uint32_t tick, EventSink& sink) noexcept;
    std::int8_t tissue_of(EnergyTarget target) const noexcept;

    bool present_ = false;
    double tick_period_ = 1e-3, safe_distance_ = 0.002, nerve_limit_ = 60;
    std::int8_t band_tissue_ = -1, bed_tissue_ = -1, nerve_tissue_ = -1, vessel_tissue_ = -1,
                sheet_tissue_ = -1, fat_tissue_ = -1;
    std::array<Span, hand_count> spans_;
    std::array<std::int32_t, hand_count> clips_fired_{}, tool_index_{};
    std::array<bool, hand_count> clipped_{};  // of the last step, which sets it again: not archived
    std::vector<std::uint8_t> band_parted_, pulled_by_, bleeding_, injured_, nerve_heated_, nerve_divided_;
    std::vector<double> outlet_ml_;
    int divided_ = 0, torn_ = 0, dry_ = 0, clips_left_ = 0;
    double lost_ml_ = 0, told_ml_ = 0, dose_ = 0, told_dose_ = 0, area_ = 0, told_area_ = 0;
    std::uint32_t told_dose_tick_ = 0, told_area_tick_ = 0;
    std::int8_t dose_tissue_ = -1;
};

}  // namespace fulcrum
