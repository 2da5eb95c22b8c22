// SPDX-License-Identifier: GPL-3.0-or-later
// Drafts of a curriculum are read, written, put together with a newer version, published and handed to
// another page.
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QStandardPaths>
#include <algorithm>

#include "database/rows/crypto.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/output_file.h"
#include "sim_core/scene/json_document.h"
#include "ui/dashboards/curriculum_page.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

/// A version without those before it.
Curriculum version_alone(const Curriculum& version) {
    Curriculum alone = version;
    alone.older.clear();
    alone.based_on.reset();
    return alone;
}

std::string name_and_text(const Curriculum& version) {
    return version.name() + '\n' + version.text;
}

QString folder_of_drafts() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QFileInfo(folder).isDir() ? folder : QDir::homePath();
}

}  // namespace

bool CurriculumPage::look_for_newer() {
    return context().guarded([&] { context().services().look_for_curriculum(); });
}

bool CurriculumPage::is_seen() const {
    return seen_ == name_and_text(in_force());
}

void CurriculumPage::meet(const Curriculum* base, DraftMeeting::Base how, int from) {
    DraftMerge merged = merge_draft(base, draft_, in_force());
    draft_ = std::move(merged.draft);
    draft_.version = in_force().next_own_version();  // a version in use is never edited
    DraftMeeting meeting{how, from, std::move(merged.taken), std::move(merged.collisions)};
    if (meeting_ && meeting_->base == how && how == DraftMeeting::Base::known) {
        meeting.from = meeting_->from;
        for (const DraftDifference& one : meeting_->taken)
            if (std::find(meeting.taken.begin(), meeting.taken.end(), one) == meeting.taken.end())
                meeting.taken.push_back(one);
    }
    seen_ = name_and_text(in_force());
    base_.reset();
    if (base != nullptr) base_ = version_alone(*base);
    meeting_.reset();
    if (!meeting.taken.empty() || !meeting.collisions.empty()) meeting_ = std::move(meeting);
    settle();
    title_->setText(tr("%1, version %2").arg(asset_text(in_force().title)).arg(in_force().version));
}

bool CurriculumPage::meet_newer() {
    if (is_seen()) return false;
    const std::optional<Curriculum> base = base_;
    if (base)
        meet(&*base, DraftMeeting::Base::known, base->version);
    else
        meet(nullptr, meeting_ ? meeting_->base : DraftMeeting::Base::not_named,
             meeting_ ? meeting_->from : 0);
    fill(std::max(0, tasks_->currentRow()));
    say_meeting();
    return true;
}

void CurriculumPage::say_meeting() {
    if (meeting_ && !meeting_->collisions.empty())
        context().complain(tr("Version %1 is in force and differs from your draft. Decide each of the "
                              "differences that are listed, then publish.")
                               .arg(in_force().version));
    else
        context().say(tr("Version %1 is in force. Its changes and yours are in the draft together. Look at "
                         "it, then publish.")
                          .arg(in_force().version));
}

void CurriculumPage::settle() {
    if (!is_seen()) return;
    if (meeting_) meeting_->collisions = collisions_left(meeting_->collisions, draft_, in_force());
    if (meeting_ && !meeting_->collisions.empty()) return;
    if (!base_ || name_and_text(*base_) != seen_) base_ = version_alone(in_force());
}

CurriculumProblem CurriculumPage::collision_problem(const DraftDifference& one) {
    const BothValues both = both_values(one, draft_, in_force(), context().services().tasks());
    CurriculumProblem problem;
    problem.field = field_of(one, draft_);
    if (const CurriculumTask* task = draft_.find(one.of))
        problem.index = static_cast<std::size_t>(task - draft_.tasks.data());
    problem.problem = {QT_TRANSLATE_NOOP("errors", "the draft has “%1”, version %2 has “%3”"),
                       plain(both.draft), in_force().version, plain(both.in_force)};
    if (problem.field == CurriculumField::title || problem.field == CurriculumField::stages)
        problem.problem = {"%1: %2", plain(part_words(one)), problem.problem};
    problem.hint = QT_TRANSLATE_NOOP("errors", "decide it under “Changes by two authors”");
    return problem;
}

void CurriculumPage::decide(int row, bool as_in_force) {
    if (!meeting_ || row < 0 || row >= static_cast<int>(meeting_->collisions.size())) return;
    const DraftDifference one = meeting_->collisions[static_cast<std::size_t>(row)];
    if (as_in_force) take_part(draft_, in_force(), one);
    meeting_->collisions.erase(meeting_->collisions.begin() + row);
    fill(std::max(0, tasks_->currentRow()));
}

const Curriculum* CurriculumPage::version_of(const DraftOrigin& origin) const {
    const Curriculum* known = in_force().version_named(in_force().id + "@" + std::to_string(origin.version));
    return known != nullptr && database::sha256_hex(known->text) == origin.sha256 ? known : nullptr;
}

void CurriculumPage::open_draft() {
    auto* dialog = new QFileDialog(this, tr("Draft of a curriculum"), draft_path());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilter(tr("Curricula (*.json)"));
    connect(dialog, &QFileDialog::fileSelected, this, &CurriculumPage::read_draft);
    dialog->open();
}

void CurriculumPage::read_draft(const QString& path) {
    Curriculum opened;
    KnownFile known;
    if (!context().guarded([&] {
            known.path = QDir::fromNativeSeparators(path);
            const std::string file = plain(known.path);
            known.text = read_text_file(file, JsonLimits().bytes);
            opened = parse_draft(known.text, file);
            if (opened.id != in_force().id)
                throw InputError(file, "/id",
                                 {QT_TRANSLATE_NOOP("errors", "is another curriculum: %1"), opened.id},
                                 {QT_TRANSLATE_NOOP("errors", "open a draft of %1"), in_force().id});
        }))
        return;
    if (!look_for_newer()) return;
    const std::optional<DraftOrigin> origin = opened.based_on;
    const Curriculum* base = origin ? version_of(*origin) : nullptr;
    draft_ = std::move(opened);
    draft_.based_on.reset();
    file_ = known;
    meeting_.reset();
    meet(base,
         base != nullptr ? DraftMeeting::Base::known
         : origin        ? DraftMeeting::Base::not_here
                         : DraftMeeting::Base::not_named,
         origin ? origin->version : 0);
    set_quietly(path_, QDir::toNativeSeparators(known.path));
    fill(0);
    if (meeting_) say_meeting();
}

QString CurriculumPage::draft_path() const {
    QString typed = QDir::fromNativeSeparators(path_->text().trimmed());
    if (typed.isEmpty() || QFileInfo(typed).isDir()) return typed;
    if (!typed.endsWith(QLatin1String(".json"), Qt::CaseInsensitive)) typed += QLatin1String(".json");
    return QDir(folder_of_drafts()).filePath(typed);  // as it is where it is absolute
}

void CurriculumPage::propose_path() {
    // A draft of somebody else, who was offered the same name, is not in the way.
    const QString name = QStringLiteral("%1-%2").arg(text(draft_.id)).arg(draft_.version);
    const QDir folder(folder_of_drafts());
    QString path = folder.filePath(name + QStringLiteral(".json"));
    for (int number = 2; QFileInfo::exists(path); ++number)
        path = folder.filePath(QStringLiteral("%1 (%2).json").arg(name).arg(number));
    set_quietly(path_, QDir::toNativeSeparators(path));
}

std::string CurriculumPage::draft_text() const {
    Curriculum saved = draft_;
    if (base_) saved.based_on = DraftOrigin{base_->version, database::sha256_hex(base_->text)};
    return curriculum_text(saved);
}

bool CurriculumPage::is_unsaved() const {
    return is_changed() && draft_text() != file_.text;
}

QStringList CurriculumPage::begun_input(Ending ending) const {
    if (ending != Ending::window || author_.empty() || !is_unsaved()) return {};
    return {tr("a draft of the curriculum")};
}

void CurriculumPage::save() {
    const QString path = draft_path();
    const std::string file = plain(path);
    const bool written = context().guarded([&] {
        const std::string content = draft_text();
        parse_draft(content, file);  // what is written can be read
        if (path == file_.path && QFileInfo::exists(path) &&
            read_text_file(file, JsonLimits().bytes) != file_.text)
            throw InputError(
                file, "", QT_TRANSLATE_NOOP("errors", "somebody has changed this file since you opened it"),
                QT_TRANSLATE_NOOP("errors", "save your draft under another name"));
        write_output_file(file, content);
        file_ = {path, content};
    });
    if (written) set_quietly(path_, QDir::toNativeSeparators(path));
    look();
    if (written)
        context().say(
            tr("Wrote %1. It is a draft: nothing has changed yet.").arg(QDir::toNativeSeparators(path)));
}

void CurriculumPage::publish() {
    // Somebody may have been faster: in another window, or at another station.
    if (!look_for_newer() || meet_newer() || !base_) return;
    const bool done = context().guarded([&] {
        context().services().publish_curriculum(context().session(), *base_, curriculum_text(draft_),
                                                plain(reason_->text().trimmed()));
    });
    if (!done) {
        if (!look_for_newer() || !meet_newer()) look();
        return;
    }
    const int row = std::max(0, tasks_->currentRow());
    start_over();
    fill(row);
    context().say(tr("Version %1 is in force. People who have begun stay on theirs until you move them.")
                      .arg(in_force().version));
}

std::optional<CurriculumPage::Begun> CurriculumPage::begun() const {
    if (author_.empty() || !is_changed()) return std::nullopt;
    return Begun{draft_,        base_,   meeting_,
                 seen_,         author_, reason_->text(),
                 path_->text(), file_,   tasks_->currentRow(),
                 !is_unsaved()};
}

void CurriculumPage::take_up(const Begun& from) {
    read_installed();
    start_over();
    draft_ = from.draft;
    base_ = from.base;
    meeting_ = from.meeting;
    seen_ = from.seen;
    author_ = from.author;
    file_ = from.file;
    set_quietly(reason_, from.reason);
    set_quietly(path_, from.path);
    fill(from.row);
    meet_newer();
}

}  // namespace fulcrum::ui
