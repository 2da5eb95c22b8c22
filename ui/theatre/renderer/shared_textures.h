// SPDX-License-Identifier: GPL-3.0-or-later
// Textures of anatomy that several pictures show: those of the theatre, of a replay next to it, of a
// specimen. Making them takes longer than everything else that a scene's picture needs.
#pragma once

#include <cstdint>
#include <memory>

#include "sim_core/anatomy/anatomy.h"

namespace fulcrum::ui {

/// What make_textures() gives for these. The last two that were asked for are kept (27 MB each at size 1024);
/// others live as long as somebody uses them. From any thread; two who ask at once wait for each other.
std::shared_ptr<const AnatomyTextures> shared_textures(std::uint64_t seed, int size);

/// What make_wall_texture() gives for this cavity and the peritoneum of shared_textures(seed, size). The last
/// two that were asked for are kept (17 MB each). From any thread; two who ask at once wait for each other.
std::shared_ptr<const TissueTexture> shared_wall_texture(const CavityShape& cavity, std::uint64_t seed,
                                                         int size);

/// What make_areolar_texture() gives without arguments; made once. From any thread.
std::shared_ptr<const TissueTexture> shared_areolar_texture();

}  // namespace fulcrum::ui
