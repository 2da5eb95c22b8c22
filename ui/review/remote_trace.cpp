// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/remote_trace.h"

#include <QCoreApplication>

#include "database/sync/trace_fetch.h"
#include "ui/language/error_text.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

struct RemoteTraceTexts {
    Q_DECLARE_TR_FUNCTIONS(RemoteTrace)
};

}  // namespace

bool bring_trace(const std::string& store_path, const database::Session& session,
                 const std::string& attempt_id, const Progress& progress) {
    if (database::ServerAddress::is_address(store_path)) return true;  // it is there
    {
        database::StoreOptions reading;
        reading.read_only = true;
        const database::Store store = database::Store::open(store_path, reading);
        if (!database::can_fetch_trace(store, session, attempt_id)) return true;
    }
    database::StoreOptions writing;
    writing.close_interrupted = false;
    const database::Store store = database::Store::open(store_path, writing);
    const std::string line =
        plain(RemoteTraceTexts::tr("Fetching the recording from the programme server …"));
    double so_far = 0;
    database::SyncOptions options;
    options.progress = [&](double done, const std::string&) { so_far = done; };
    options.stop = [&] { return progress && !progress(so_far, line); };
    try {
        return database::fetch_trace(store, session, database::server_of(store), attempt_id, options)
            .complete;
    } catch (const database::StoreError& error) {
        if (error.kind() != database::StoreErrorKind::unreachable) throw;
        throw database::StoreError(
            database::StoreErrorKind::unreachable,
            QT_TRANSLATE_NOOP("errors",
                              "the recording of this attempt is on the programme server, which cannot be "
                              "reached now"),
            error.hint_sentence());
    }
}

std::optional<AttemptModel> load_with_trace(const std::string& store_path, const database::Session& session,
                                            const std::string& attempt_id, const std::optional<Scene>& scene,
                                            const Progress& progress, TraceElsewhere& elsewhere) {
    try {
        if (!bring_trace(store_path, session, attempt_id, progress)) return std::nullopt;
    } catch (const database::StoreError& error) {
        elsewhere = {error_text(error), true};
    }
    database::StoreOptions options;
    options.read_only = true;
    const database::Store store = database::Store::open(store_path, options);
    if (elsewhere.why.isEmpty()) {
        try {
            return load_attempt(store, session, attempt_id, scene, progress);
        } catch (const database::StoreError& error) {
            if (error.kind() != database::StoreErrorKind::not_found) throw;
            elsewhere.why = error_text(error);
        }
    }
    const database::Attempts attempts(store);
    database::AttemptSummary summary = attempts.read(session, attempt_id);
    summary.meta.keep_trace = false;
    AttemptModel model =
        model_of_trace(std::move(summary), std::nullopt, std::make_shared<const database::Trace>(), scene);
    take_scores(attempts, session, model);
    return model;
}

}  // namespace fulcrum::ui
