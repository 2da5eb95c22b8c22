// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/station_note.h"

#include "database/sync/enrolment.h"
#include "ui/language/error_text.h"

namespace fulcrum::ui {

StationNote::StationNote() {
    setObjectName(QStringLiteral("station_note"));
    setWordWrap(true);
    setTextFormat(Qt::PlainText);
    hide();
}

void StationNote::look(Context& context) {
    std::optional<Sentence> scope;
    context.guarded([&] { scope = database::station_scope(context.store(), context.session()); });
    setText(scope ? sentence_text(*scope) : QString());
    setVisible(scope.has_value());
}

}  // namespace fulcrum::ui
