// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/frame_keeping.h"

#include "database/records/attempts.h"
#include "database/store/kept_frames.h"

namespace fulcrum::app {

FrameKeeping frame_keeping(const database::Store& store, const database::Session& session,
                           const std::string& attempt_id, const LoadedTask& loaded) {
    FrameKeeping keeping;
    keeping.folder = database::kept_frames_folder(store);
    if (keeping.folder.empty()) return keeping;
    keeping.name = database::kept_frames_name(attempt_id);
    std::string record = database::Attempts(store).record_digest(session, attempt_id) + '\n' +
                         loaded.scene_text + '\n' + std::to_string(loaded.scene.tick_rate) + '\n';
    for (const database::AssetFile& file : loaded.assets) record += file.name + ' ' + file.digest + '\n';
    keeping.belongs = frames_belong_to(record);
    return keeping;
}

FrameKeeping frame_keeping(const std::string& store_path, const database::Session& session,
                           const std::string& attempt_id) noexcept {
    try {
        database::StoreOptions options;
        options.close_interrupted = false;
        const database::Store store = database::Store::open(store_path, options);
        const database::Attempts attempts(store);
        return frame_keeping(store, session, attempt_id,
                             load_recorded(attempts, session, attempts.read(session, attempt_id)));
    } catch (const std::exception&) {
        return {};
    }
}

}  // namespace fulcrum::app
