// SPDX-License-Identifier: Apache-2.0
#include "assessment/attempt/engine_state.h"

#include "sim_core/numerics/state_archive.h"

namespace fulcrum {

std::vector<std::uint8_t> engine_state(AttemptEngine& engine) {
    std::vector<std::uint8_t> bytes;
    StateArchive archive(bytes);
    engine.transfer(archive);
    archive.finish();
    return bytes;
}

void restore_engine(AttemptEngine& engine, const std::vector<std::uint8_t>& state) {
    StateArchive archive(state.data(), state.size());
    engine.transfer(archive);
    archive.finish();
    engine.show_restored();
}

}  // namespace fulcrum
