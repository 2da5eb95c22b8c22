// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/shared_textures.h"

#include <algorithm>
#include <mutex>
#include <vector>

namespace fulcrum::ui {
namespace {

struct KeptTextures {
    std::uint64_t seed = 0;
    int size = 0;
    std::shared_ptr<const AnatomyTextures> textures;
};

struct KeptWall {
    CavityShape cavity;
    std::uint64_t seed = 0;
    int size = 0;
    std::shared_ptr<const TissueTexture> texture;
};

constexpr std::size_t most_kept = 2;

bool is_same(const CavityShape& a, const CavityShape& b) {
    return a.mesh.vertices == b.mesh.vertices && a.mesh.triangles == b.mesh.triangles &&
           a.mesh.texture_coordinates == b.mesh.texture_coordinates && a.fat == b.fat;
}

}  // namespace

std::shared_ptr<const AnatomyTextures> shared_textures(std::uint64_t seed, int size) {
    static std::mutex one_at_a_time;
    static std::vector<KeptTextures> kept;  // the newest first
    const std::lock_guard lock(one_at_a_time);
    const auto found = std::find_if(kept.begin(), kept.end(), [&](const KeptTextures& one) {
        return one.seed == seed && one.size == size;
    });
    if (found != kept.end()) {
        std::rotate(kept.begin(), found, found + 1);
    } else {
        auto made = std::make_shared<const AnatomyTextures>(make_textures(seed, size));
        kept.insert(kept.begin(), {seed, size, std::move(made)});
        if (kept.size() > most_kept) kept.pop_back();
    }
    return kept.front().textures;
}

std::shared_ptr<const TissueTexture> shared_wall_texture(const CavityShape& cavity, std::uint64_t seed,
                                                         int size) {
    static std::mutex one_at_a_time;
    static std::vector<KeptWall> kept;  // the newest first
    const std::lock_guard lock(one_at_a_time);
    const auto found = std::find_if(kept.begin(), kept.end(), [&](const KeptWall& one) {
        return one.seed == seed && one.size == size && is_same(one.cavity, cavity);
    });
    if (found != kept.end()) {
        std::rotate(kept.begin(), found, found + 1);
    } else {
        auto made = std::make_shared<const TissueTexture>(
            make_wall_texture(cavity, shared_textures(seed, size)->peritoneum));
        kept.insert(kept.begin(), {cavity, seed, size, std::move(made)});
        if (kept.size() > most_kept) kept.pop_back();
    }
    return kept.front().texture;
}

std::shared_ptr<const TissueTexture> shared_areolar_texture() {
    static const auto texture = std::make_shared<const TissueTexture>(make_areolar_texture());
    return texture;
}

}  // namespace fulcrum::ui
