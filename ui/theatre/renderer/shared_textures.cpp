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

constexpr std::size_t most_kept = 2;

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

std::shared_ptr<const TissueTexture> shared_areolar_texture() {
    static const auto texture = std::make_shared<const TissueTexture>(make_areolar_texture());
    return texture;
}

}  // namespace fulcrum::ui
