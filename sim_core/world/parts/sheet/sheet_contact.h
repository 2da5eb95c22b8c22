// SPDX-License-Identifier: Apache-2.0
// Tips and jaws on the sheet: what lies under them, from which side, how they hold it, what the hand is
// given. Scratch: the links that this step's membrane solve gets.
#pragma once

#include <array>
#include <vector>

#include "sim_core/contact/jaws.h"
#include "sim_core/contact/local_model.h"
#include "sim_core/world/part/part.h"
#include "sim_core/world/parts/sheet/sheet_body.h"

namespace fulcrum {

class SheetContact {
  public:
    explicit SheetContact(SheetBody& sheet);
    /// Jaws that would take hold in this step if something is within their reach.
    bool closing(int hand, const SheetAction& action) const noexcept;
    double offer(int hand, const HeldTool& held) const noexcept;  ///< Part::offer
    void update_jaws(int hand, const SheetAction& action, double dt) noexcept;
    void approach(int hand, const SheetAction& action, std::uint32_t tick, double dt) noexcept;
    /// Jaws and tips as links of the membrane's solve; what they bore in it.
    void add_links(const SheetAction* actions) noexcept;
    void read_links() noexcept;
    void publish(int hand, LocalModel& model) const noexcept;  ///< Part::publish_model

  private:
    struct Near {
        SheetPlace place;
        Vector3 point = Vector3::Zero(), normal = Vector3::UnitZ();
        double distance = 0, gap = 0, cover = 0;
    };
    struct Approach;  // the blade law's tissue before the sheet is solved
    Near find_near(const Vector3& tip, double radius) noexcept;
    bool has_lost(const SheetHand& hand) const noexcept;
    double area_in(const JawBox& box) const noexcept;
    void take(int hand, const SheetAction& action) noexcept;
    void fill_touch(const SheetHand& hand, SheetContactModel& model) const noexcept;
    void fill_grasp(const SheetHand& hand, LocalModel& model) const noexcept;

    SheetBody& sheet_;
    std::array<int, hand_count> tip_link_ = {-1, -1}, jaw_link_ = {-1, -1};
    std::vector<SheetBody::VisibleTriangle> near_;
};

}  // namespace fulcrum
