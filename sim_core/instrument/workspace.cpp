// SPDX-License-Identifier: Apache-2.0
#include "sim_core/instrument/workspace.h"

#include <algorithm>

namespace fulcrum {
namespace {
constexpr double thinnest = 1e-3;  // m: a flat scene counts as this thick
}  // namespace

bool is_usable(const WorkspaceBox& box) {
    if (!box.least.allFinite() || !box.most.allFinite()) return false;
    const Vector3 size = box.size();
    return size.minCoeff() >= 0.01 && size.maxCoeff() <= 4 && box.least.cwiseAbs().maxCoeff() <= 10 &&
           box.most.cwiseAbs().maxCoeff() <= 10;
}

double scale_to_fit(const WorkspaceBox& workspace, const WorkspaceBox& scene) {
    return scene.size().cwiseQuotient(workspace.size()).maxCoeff();
}

Vector3 place_to_begin(const WorkspaceBox& workspace, const WorkspaceBox& scene, double motion) {
    return workspace.centre() - scene.centre() / motion;
}

WorkspaceBox needed(const WorkspaceBox& scene, double motion, const Vector3& begun) {
    return {begun + scene.least / motion, begun + scene.most / motion};
}

double reached_share(const WorkspaceBox& workspace, const WorkspaceBox& scene, double motion,
                     const Vector3& begun) {
    WorkspaceBox wanted = needed(scene, motion, begun);
    double share = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double grow = std::max(0.0, thinnest - wanted.size()[axis]) / 2;
        wanted.least[axis] -= grow;
        wanted.most[axis] += grow;
        const double overlap = std::min(workspace.most[axis], wanted.most[axis]) -
                               std::max(workspace.least[axis], wanted.least[axis]);
        share *= std::clamp(overlap / wanted.size()[axis], 0.0, 1.0);
    }
    return share;
}

}  // namespace fulcrum
