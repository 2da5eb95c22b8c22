// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/administration/stations_card.h"

#include <memory>

#include "ui/language/language.h"
#include "ui/page/background_job.h"
#include "ui/style/standing_badge.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

StationsCard::StationsCard(Context& context) : context_(context) {
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 16, 18, 16);
    layout->setSpacing(8);
    layout->addWidget(make_label(tr("Stations of the programme"), "heading"));
    layout->addWidget(make_label(tr("Those whose attempts this station has. What another one did since its "
                                    "last exchange with the server is not known here."),
                                 "muted"));
    table_ = make_table({tr("Station"), tr("Attempts"), tr("Newest"), tr("Since"), tr("Key")}, "stations");
    table_->setAccessibleName(tr("Stations of the programme"));
    table_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    layout->addWidget(table_);
}

void StationsCard::look() {
    stop();
    hide();
    if (!context_.allowed(database::Operation::view_audit)) return;
    auto stations = std::make_shared<std::vector<database::KnownStation>>();
    job_ = BackgroundJob::run(
        this,
        [stations, session = context_.session(), path = context_.store().path()](const Progress&) {
            database::StoreOptions options;
            options.read_only = true;
            *stations = database::known_stations(database::Store::open(path, options), session);
        },
        [this, stations] {
            job_ = nullptr;
            show_stations(*stations);
        },
        [this](const QString& why) {
            job_ = nullptr;
            context_.complain(why);
        });
}

void StationsCard::stop() {
    if (job_ != nullptr) job_->cancel();
    job_ = nullptr;
}

void StationsCard::show_stations(const std::vector<database::KnownStation>& stations) {
    if (stations.size() < 2) return;
    show();
    table_->setRowCount(0);
    for (const database::KnownStation& one : stations) {
        const int row = table_->rowCount();
        table_->insertRow(row);
        table_->setItem(row, 0,
                        make_cell(one.own ? tr("%1 (this one)").arg(text(one.name)) : text(one.name)));
        table_->setItem(row, 1,
                        make_cell(QLocale().toString(static_cast<qlonglong>(one.attempts)),
                                  Qt::AlignRight | Qt::AlignVCenter));
        table_->setItem(row, 2, make_cell(one.newest == 0 ? tr("nothing yet") : date_text(one.newest)));
        table_->setItem(row, 3, make_cell(date_text(one.created)));
        table_->setItem(row, 4,
                        make_cell(one.key.empty() ? tr("not known here") : text(one.key.substr(0, 16))));
        table_->item(row, 4)->setToolTip(text(one.key));
    }
    fit_columns(table_);
    constexpr int most_rows = 20;
    fit_height(table_, most_rows);
}

}  // namespace fulcrum::ui

#include "moc_stations_card.cpp"
