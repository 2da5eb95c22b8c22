// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/benchmark_page.h"

#include <QComboBox>
#include <QDir>
#include <QHeaderView>
#include <QLineEdit>
#include <algorithm>

#include "assessment/assets/assets.h"
#include "database/scoring/scoring.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/output_file.h"
#include "sim_core/scene/fidelity.h"
#include "ui/dashboards/limit_rows.h"
#include "ui/language/language.h"
#include "ui/page/background_job.h"
#include "ui/style/announce.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

enum PeopleColumn { person_column, performed_column, counted_column };

/// With the fewest experts and attempts that a set is made of.
const BenchmarkRequest& least() {
    static const BenchmarkRequest request;
    return request;
}

QFrame* titled_card(const QString& title) {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(make_label(title, "heading"));
    return card;
}

/// In force for the key; nothing where its file cannot be read, which building the set says.
std::optional<BenchmarkSet> readable_set(const BenchmarkKey& key) {
    try {
        return benchmark_in_force(key).set;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

void show_all_rows(QTableWidget* table, int most) {
    int height = table->horizontalHeader()->sizeHint().height() + table->fontMetrics().height();
    for (int row = 0; row < std::min(most, table->rowCount()); ++row) height += table->rowHeight(row);
    table->setMinimumHeight(height);
}

}  // namespace

BenchmarkPage::BenchmarkPage(Context& context) : Page(context, "benchmark_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(12);
    layout->addWidget(make_label(tr("Build limits"), "title"));
    layout->addWidget(make_label(tr("A benchmark set is made from the assessed attempts of at least %1 "
                                    "experts who performed the task %2 "
                                    "times or more. The first %3 attempts of each person are familiarisation "
                                    "and do not count. Nothing "
                                    "changes until you put the set in force.")
                                     .arg(least().minimum_experts)
                                     .arg(familiarisation_attempts + least().minimum_attempts)
                                     .arg(familiarisation_attempts),
                                 "muted"));
    layout->addWidget(make_choice());
    layout->addWidget(make_experts());
    job_bar_ = new JobBar;
    layout->addWidget(job_bar_);
    connect(job_bar_, &JobBar::cancelled, this, [this] {
        job_ = nullptr;
        look();
    });
    result_ = make_result();
    layout->addWidget(result_);
    layout->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body));
    result_->hide();
}

QFrame* BenchmarkPage::make_choice() {
    QFrame* card = titled_card(tr("What the limits are for"));
    auto* row = new FlowRow;
    const auto add = [&](QComboBox*& box, const char* name, const QString& title) {
        box = make_narrow_choice(name, title, 12);
        row->add(box, 1, with_text(255));
    };
    add(tasks_, "benchmark_task", tr("Task"));
    add(variants_, "benchmark_variant", tr("Variant"));
    add(devices_, "benchmark_device", tr("Class of devices"));
    add(fidelities_, "benchmark_fidelity", tr("Fidelity"));
    card_layout(card)->addLayout(row);
    left_ = make_label({});
    left_->setObjectName(QStringLiteral("benchmark_left"));
    set_tint(left_, Tint::bad);
    card_layout(card)->addWidget(left_);
    for (const NameRow<DeviceClass>& one : device_classes)
        if (limits_class(one.kind) == one.kind)
            devices_->addItem(device_class_text(one.kind), static_cast<int>(one.kind));
    for (const NameRow<FidelityLevel>& one : fidelity_levels)
        fidelities_->addItem(QStringLiteral("%1: %2").arg(
                                 tr("Fidelity"), QCoreApplication::translate("fulcrum::fidelity", one.title)),
                             QString::fromLatin1(one.name));
    fidelities_->setCurrentIndex(fidelities_->findData(QString::fromLatin1(standard_fidelity)));
    connect(tasks_, qOverload<int>(&QComboBox::activated), this, &BenchmarkPage::choose_task);
    for (QComboBox* box : {variants_, devices_, fidelities_})
        connect(box, qOverload<int>(&QComboBox::activated), this, &BenchmarkPage::choose_key);
    return card;
}

QFrame* BenchmarkPage::make_experts() {
    QFrame* card = titled_card(tr("Experts"));
    count_ = make_label({}, "muted");
    count_->setObjectName(QStringLiteral("benchmark_count"));
    card_layout(card)->addWidget(count_);
    people_ = make_table({tr("Person"), tr("Attempts"), tr("Counted")}, "benchmark_people");
    people_->setAccessibleName(tr("People with attempts at this task"));
    card_layout(card)->addWidget(people_);
    build_ = make_button(tr("Build the set"), "benchmark_build", "primary");
    card_layout(card)->addWidget(build_, 0, Qt::AlignLeft);
    connect(people_, &QTableWidget::itemChanged, this, &BenchmarkPage::keep_ticks);
    connect(build_, &QPushButton::clicked, this, &BenchmarkPage::build);
    return card;
}

QFrame* BenchmarkPage::make_result() {
    QFrame* card = titled_card(tr("The set"));
    verdict_ = make_label({});
    verdict_->setObjectName(QStringLiteral("benchmark_verdict"));
    card_layout(card)->addWidget(verdict_);
    dots_ = make_label({}, "muted");
    card_layout(card)->addWidget(dots_);
    chart_ = new LimitsChart;
    card_layout(card)->addWidget(chart_);
    passes_ = make_table(pass_columns(), "benchmark_passes");
    passes_->setAccessibleName(tr("Who would pass with each set"));
    card_layout(card)->addWidget(passes_);
    explained_ = make_label({}, "muted");
    explained_->setObjectName(QStringLiteral("benchmark_explained"));
    card_layout(card)->addWidget(explained_);
    site_ = make_label({});
    site_->setObjectName(QStringLiteral("benchmark_site"));
    card_layout(card)->addWidget(site_);
    saving_ = make_saving();
    card_layout(card)->addWidget(saving_);
    return card;
}

QWidget* BenchmarkPage::make_saving() {
    auto* holder = new QWidget;
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](QLineEdit*& edit, QPushButton*& button, const char* edit_name,
                         const QString& placeholder, const QString& words, const char* button_name,
                         const char* role) {
        auto* row = new FlowRow;
        edit = new QLineEdit;
        edit->setObjectName(QLatin1String(edit_name));
        edit->setAccessibleName(placeholder);
        edit->setPlaceholderText(placeholder);
        row->add(edit, 1, with_text(240));
        button = make_button(words, button_name, role);
        row->add(button);
        column->addLayout(row);
        connect(edit, &QLineEdit::textChanged, this, &BenchmarkPage::look);
    };
    add(note_, put_, "benchmark_note", tr("Why this set is made (in the audit log and in the set)"),
        tr("Put in force"), "benchmark_put", "primary");
    note_->setMaxLength(1000);
    add(path_, save_, "benchmark_path", tr("File for another station, or for the administrator"),
        tr("Save to a file"), "benchmark_save", nullptr);
    connect(put_, &QPushButton::clicked, this, &BenchmarkPage::put_in_force);
    connect(save_, &QPushButton::clicked, this, &BenchmarkPage::save);
    return holder;
}

const TaskDefinition* BenchmarkPage::task() const {
    return context().task(plain(tasks_->currentData().toString()));
}

BenchmarkKey BenchmarkPage::key() const {
    return {plain(tasks_->currentData().toString()), plain(variants_->currentData().toString()),
            static_cast<DeviceClass>(devices_->currentData().toInt()),
            plain(fidelities_->currentData().toString())};
}

void BenchmarkPage::enter() {
    if (tasks_->count() == 0) {
        for (const TaskDefinition& one : context().services().tasks())
            if (std::any_of(one.gates.begin(), one.gates.end(),
                            [](const GateSpec& gate) { return gate.kind == GateKind::benchmark; }))
                tasks_->addItem(context().task_title(one.id), text(one.id));
    }
    // A set that was built stays when somebody comes back; else it is read again who may be named.
    if (!built_) choose_task();
    look();  // the role may be another one by now
    tasks_->setFocus();
}

void BenchmarkPage::leave() {
    if (job_ != nullptr) job_->cancel();
    job_ = nullptr;
}

void BenchmarkPage::choose_task() {
    const QVariant before = variants_->currentData();
    variants_->clear();
    if (task() == nullptr) return;
    for (const TaskVariant& variant : task()->variants)
        if (variant.family == variant.id)
            variants_->addItem(QStringLiteral("%1: %2").arg(tr("Variant"), asset_text(variant.title)),
                               text(variant.id));
    variants_->setCurrentIndex(std::max(0, variants_->findData(before)));
    choose_key();
}

/// `work` gets a store of its own, and a function that it tells how far it is.
void BenchmarkPage::run(std::function<void(const database::Store&, const std::function<bool(double)>&)> work,
                        std::function<void()> done, const QString& line) {
    if (job_ != nullptr) job_->cancel();
    job_ = BackgroundJob::run(
        this,
        [work = std::move(work), path = context().store().path()](const Progress& progress) {
            database::StoreOptions options;
            options.read_only = true;
            const database::Store store = database::Store::open(path, options);
            work(store, [&](double share) { return progress(share, {}); });
        },
        [this, done = std::move(done)] {
            job_ = nullptr;
            done();
        },
        [this](const QString& why) {
            job_ = nullptr;
            look();
            context().complain(why);
        });
    job_bar_->watch(job_, line);
    look();
}

void BenchmarkPage::choose_key() {
    built_.reset();
    known_ = false;
    result_->hide();
    show_candidates({});
    show_left(std::nullopt);
    if (task() == nullptr) return;
    struct Found {
        std::vector<ExpertCandidate> candidates;
        std::optional<BenchmarkSet> in_force;
    };
    auto found = std::make_shared<Found>();
    run(
        [found, session = context().session(), task = *task(), key = key()](
            const database::Store& store, const std::function<bool(double)>&) {
            found->candidates = expert_candidates(store, session, task, key);
            found->in_force = readable_set(key);
        },
        [this, found] {
            known_ = true;
            show_left(found->in_force);
            show_candidates(std::move(found->candidates));
        },
        tr("Reading the attempts …"));
}

/// Why passes with the site's own set are still provisional.
void BenchmarkPage::show_left(const std::optional<BenchmarkSet>& in_force) {
    left_->setText(in_force && task() != nullptr ? left_provisional_words(*task(), *in_force) : QString());
    left_->setVisible(!left_->text().isEmpty());
}

void BenchmarkPage::show_candidates(std::vector<ExpertCandidate> candidates) {
    candidates_ = std::move(candidates);
    const std::set<std::string> ticked = ticked_[benchmark_name(key())];
    const QSignalBlocker quiet(people_);
    people_->setRowCount(static_cast<int>(candidates_.size()));
    for (int row = 0; row < people_->rowCount(); ++row) {
        const ExpertCandidate& one = candidates_[static_cast<std::size_t>(row)];
        auto* name = make_cell(tr("%1 (%2)").arg(text(one.name), text(one.login)));
        name->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        name->setCheckState(ticked.count(one.person_id) > 0 ? Qt::Checked : Qt::Unchecked);
        people_->setItem(row, person_column, name);
        people_->setItem(row, performed_column,
                         make_cell(QString::number(one.performed), Qt::AlignRight | Qt::AlignVCenter));
        auto* counted = make_cell(QString::number(one.counted()), Qt::AlignRight | Qt::AlignVCenter);
        if (one.counted() < least().minimum_attempts) set_tint(counted, Tint::muted);
        people_->setItem(row, counted_column, counted);
    }
    fit_columns(people_);
    show_all_rows(people_, 8);
    look();
}

/// For each key: another choice and back loses no check mark.
void BenchmarkPage::keep_ticks() {
    std::set<std::string> now;
    for (const ExpertCandidate& one : chosen()) now.insert(one.person_id);
    std::set<std::string>& before = ticked_[benchmark_name(key())];
    if (now != before) unsaved_.insert_or_assign(benchmark_name(key()), key());
    before = std::move(now);
    look();
}

QStringList BenchmarkPage::begun_input(Ending ending) const {
    QStringList begun = Page::begun_input(ending);
    for (const auto& [name, of] : unsaved_) {
        const auto ticked = ticked_.find(name);
        if ((ticked != ticked_.end() && !ticked->second.empty()) || (built_ && name == benchmark_name(key())))
            begun << tr("a set of limits that is being built (%1)").arg(key_text(of));
    }
    return begun;
}

std::vector<ExpertCandidate> BenchmarkPage::chosen() const {
    std::vector<ExpertCandidate> experts;
    for (int row = 0; row < people_->rowCount(); ++row)
        if (people_->item(row, person_column)->checkState() == Qt::Checked)
            experts.push_back(candidates_[static_cast<std::size_t>(row)]);
    return experts;
}

/// What can be done now.
void BenchmarkPage::look() {
    const std::vector<ExpertCandidate> experts = chosen();
    const auto enough = std::count_if(experts.begin(), experts.end(), [](const ExpertCandidate& one) {
        return one.counted() >= least().minimum_attempts;
    });
    if (candidates_.empty()) {
        count_->setText(job_ != nullptr ? QString()
                        : known_ ? tr("Nobody has an assessed and completed attempt of this kind here.")
                                 : tr("The attempts were not read. Choose the task again to read them."));
    } else {
        count_->setText(
            tr("Chosen: %1, of them with at least %2 counted attempts: %3. At least %4 are needed.")
                .arg(experts.size())
                .arg(least().minimum_attempts)
                .arg(enough)
                .arg(least().minimum_experts));
    }
    build_->setEnabled(job_ == nullptr && !experts.empty());
    const bool usable = built_ && built_->build.set && job_ == nullptr;
    const bool allowed = context().signed_in() && context().allowed(database::Operation::accept_assets);
    put_->setEnabled(usable && allowed && !note_->text().trimmed().isEmpty());
    save_->setEnabled(usable && !path_->text().trimmed().isEmpty());
}

void BenchmarkPage::build() {
    built_.reset();
    result_->hide();
    auto built = std::make_shared<std::optional<Built>>();
    run(
        [built, session = context().session(), key = key(), experts = chosen()](
            const database::Store& store, const std::function<bool(double)>& progress) {
            const LoadedTask loaded =
                load_site_task(store, session, TaskRequest{key.task, key.variant, key.fidelity});
            constexpr double reading = 0.7;
            auto attempts = expert_attempts(store, session, loaded, key.device_class, experts,
                                            [&](double share) { return progress(reading * share); });
            if (!attempts || !progress(reading)) return;
            Built made{loaded.task,
                       build_benchmark(loaded.task,
                                       expert_request(loaded, key.device_class, next_benchmark_version(key),
                                                      std::move(*attempts))),
                       {},
                       {}};
            if (!progress(0.9)) return;
            made.in_force = benchmark_in_force(key).set;
            made.attempts = tried_attempts(store, session, loaded.task, key);
            *built = std::move(made);
        },
        [this, built] {
            built_ = std::move(*built);
            unsaved_.insert_or_assign(benchmark_name(key()), key());
            show_result();
        },
        tr("Building the set …"));
}

void BenchmarkPage::show_result() {
    result_->setVisible(built_.has_value());
    if (!built_) return;
    const BenchmarkBuild& build = built_->build;
    const bool usable = build.set.has_value();
    set_tint(verdict_, usable ? Tint::good : Tint::bad);
    verdict_->setText(usable ? tr("✓ Usable. With k = %1, %2 % of the experts' own attempts pass, each held "
                                  "against a set made "
                                  "without its expert.")
                                   .arg(decimal(build.set->k, 1))
                                   .arg(decimal(100 * build.set->expert_pass_share, 1))
                             : tr("✕ Refused: %1.").arg(sentence_text(build.refusal)));
    announce(verdict_, verdict_->text());
    explained_->setText(explained().join(QLatin1Char('\n')));
    explained_->setVisible(!explained_->text().isEmpty());
    site_->setText(limits_of_site());
    site_->setVisible(!site_->text().isEmpty());
    for (QWidget* part : std::initializer_list<QWidget*>{dots_, chart_, passes_, saving_})
        part->setVisible(usable);
    if (usable) fill_passes();
    look();
}

void BenchmarkPage::fill_passes() {
    std::vector<const BenchmarkSet*> sets;
    if (built_->in_force) sets.push_back(&*built_->in_force);
    sets.push_back(&*built_->build.set);
    dots_->setText(built_->attempts.empty()
                       ? tr("No attempt stored here counts under these limits yet.")
                       : tr("Each dot is an attempt that counts; a line with a letter is the "
                            "limit of a set."));
    chart_->show_gates(gate_limits(built_->task, sets, built_->attempts));
    passes_->setRowCount(static_cast<int>(sets.size()));
    for (int row = 0; row < passes_->rowCount(); ++row) {
        const bool is_new = row + 1 == passes_->rowCount();
        const BenchmarkSet& set = *sets[static_cast<std::size_t>(row)];
        const QString name = set_letter(static_cast<std::size_t>(row)) + QStringLiteral(" · ") +
                             (is_new ? tr("the new set (%1)") : tr("in force (%1)")).arg(set.version);
        const QStringList cells = pass_cells(name, set, built_->task, built_->attempts);
        for (int column = 0; column < passes_->columnCount(); ++column)
            passes_->setItem(row, column, make_cell(cells[column]));
    }
    fit_columns(passes_, {0});
    fit_rows(passes_);
    show_all_rows(passes_, passes_->rowCount());
}

void BenchmarkPage::put_in_force() {
    if (!built_ || !built_->build.set) return;
    BenchmarkSet set = *built_->build.set;
    set.note = plain(note_->text().trimmed());
    if (!context().guarded([&] {
            publish_benchmark(context().store(), context().session(), asset_path("benchmarks"), set,
                              set.note);
        }))
        return look();
    context().say(tr("Version %1 of %2 is in force. Attempts that have begun keep their limits.")
                      .arg(set.version)
                      .arg(text(benchmark_name(set.key()))));
    note_->clear();
    ticked_.erase(benchmark_name(set.key()));
    unsaved_.erase(benchmark_name(set.key()));
    choose_key();
}

void BenchmarkPage::save() {
    if (!built_ || !built_->build.set) return;
    BenchmarkSet set = *built_->build.set;
    set.note = plain(note_->text().trimmed());
    const QString file = path_->text().trimmed();
    if (!context().guarded([&] {
            write_output_file(QDir::fromNativeSeparators(file).toStdString(), benchmark_text(set),
                              OutputFile::Existing::keep);
        }))
        return;
    unsaved_.erase(benchmark_name(set.key()));
    context().say(
        tr("Wrote %1. Attempts are held against it once it is among the program's benchmark sets and "
           "accepted.")
            .arg(file));
}

}  // namespace fulcrum::ui

#include "moc_benchmark_page.cpp"
