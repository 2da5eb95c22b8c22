// SPDX-License-Identifier: Apache-2.0
// Jaws on tissue: the tissue between them, contact area and slip.
#pragma once

#include "sim_core/instrument/instrument.h"

namespace fulcrum {

/// The space between jaws that close, with a margin from which tissue is drawn in: as long as the jaws back
/// from the tip, as wide as the tip box, as high as the opening (the jaws turn about an axis along tool x, so
/// they open along tool y).
class JawBox {
  public:
    /// opening: rad; jaw_length, width: m.
    JawBox(const ToolKinematics& tool, double opening, double jaw_length, double width);
    bool contains(const Vector3& point) const;
    /// m2, of the contact of jaws that close on `surface` (m2, of tissue inside, both sides of a fold or
    /// sheet): at most both faces, at least what two small tips pinch (scene/perforation.h).
    double contact_area(double surface) const;

  private:
    const ToolKinematics& tool_;
    double spread_ = 0, jaw_length_ = 0, width_ = 0;
};

/// N: most force between the faces of jaws closed with `jaw_force` and what they hold, 2 mu N by friction on
/// both. Along the closing direction the jaws give way at about the same force.
double jaw_capacity(double jaw_force, double friction);

/// Force over capacity. Above 1 the tissue slides. With load but no jaw force: a large finite number.
double slip_ratio(const Vector3& force, double jaw_force, double friction);

}  // namespace fulcrum
