// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/unaccepted_files.h"

#include <QStringList>

#include "database/records/attempts.h"
#include "database/store/accepted_assets.h"
#include "ui/reports/report_texts.h"
#include "ui/style/text.h"

namespace fulcrum::ui {

std::vector<database::AssetFile> unaccepted_files(const database::Store& store,
                                                  const database::Session& session,
                                                  const database::AttemptSummary& attempt) {
    const database::AttemptMeta& meta = attempt.meta;
    if (meta.mode != AttemptMode::practice || database::is_external_task(meta.task_id)) return {};
    return database::AcceptedAssets(store).unknown(database::Attempts(store).assets(session, meta.id));
}

QString unaccepted_note(const std::vector<database::AssetFile>& files) {
    if (files.empty()) return {};
    QStringList named;
    for (const database::AssetFile& file : files)
        named << ReportTexts::tr("%1 (sha256 %2)").arg(text(file.name), text(file.digest));
    return ReportTexts::tr(
               "Practised with files that are neither part of this program nor accepted by the "
               "programme: %1. Its values cannot be compared with those of other attempts.")
        .arg(named.join(QStringLiteral(", ")));
}

}  // namespace fulcrum::ui
