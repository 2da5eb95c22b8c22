// SPDX-License-Identifier: GPL-3.0-or-later
// The first steps: a strip at the foot of the theatre that says how each thing is done that the scene needs,
// with the device in use. What a person has not done before with this kind of device is marked when the hands
// did it; the strip stays until all is, in practice. Enter ends it, F1 and Enter show it again.
#include <QSettings>
#include <algorithm>

#include "ui/style/widgets.h"
#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::ui {
namespace {

constexpr double needed_s = 8;
constexpr int most_lines = 5;  // at a time

QString strip_line(const QString& line, bool done) {
    return QStringLiteral("%1<b>%2</b>&nbsp;%3")
        .arg(done ? QStringLiteral("✓&nbsp;") : QString(),
             line.section(QLatin1Char('\t'), 0, 0)
                 .toHtmlEscaped()
                 .replace(QLatin1Char(' '), QStringLiteral("&nbsp;")),
             line.section(QLatin1Char('\t'), 1).toHtmlEscaped());
}

}  // namespace

/// What moves the hands, for the lines.
void TheatrePage::take_up(const DeviceInUse& device, MouseKeyboardInput& input) {
    using Device = MouseKeyboardInput::Device;
    hands_ = {};
    std::copy(std::begin(device.drives), std::end(device.drives), hands_.drives);
    const bool of_daemon = std::count(std::begin(device.drives), std::end(device.drives), true) > 0;
    hands_.kind = pad_ != nullptr    ? "controller"
                  : mice_ != nullptr ? "two-mice"
                  : of_daemon        ? device.kind
                                     : "mouse-keyboard";
    hands_.clutch = of_daemon ? device.clutch : ClutchButton::none;
    hands_.pedal = of_daemon ? device.pedal : pedal_of_each_hand;
    hands_title_ = of_daemon ? text(device.title) : QString();
    input.set_device(pad_ != nullptr    ? Device::controller
                     : mice_ != nullptr ? Device::two_mice
                     : of_daemon        ? Device::of_daemon
                                        : Device::mouse);
}

QString TheatrePage::learnt_key() const {
    const std::string& person = context().session().person_id();
    return QStringLiteral("learnt/%1/%2")
        .arg(person.empty() ? QStringLiteral("station") : QString::fromStdString(person),
             QString::fromStdString(hands_.kind) +
                 (session_->scene().instruments.empty() ? QStringLiteral("-scope") : QString()));
}

HandDeeds TheatrePage::learnt() const {
    return HandDeeds(QSettings().value(learnt_key(), 0).toUInt());
}

void TheatrePage::keep_learnt(const HandDeeds& deeds) const {
    const HandDeeds all = learnt() | deeds;
    if (all != learnt()) QSettings().setValue(learnt_key(), static_cast<uint>(all.to_ulong()));
}

HandDeeds TheatrePage::needed() const {
    return needed_deeds(session_->scene(), hands_);
}

HandDeeds TheatrePage::deeds() const {
    if (session_ == nullptr || watch_ == nullptr) return {};
    return watch_->done(is_one_mouse(session_->scene(), hands_)) & needed();
}

void TheatrePage::begin_teaching() {
    teaching_begun_ = true;
    known_ = learnt();
    learns_ = !session_->assessed() && (needed() & ~known_).any();
}

void TheatrePage::skip_teaching() {
    keep_learnt(needed());
    learns_ = false;
    strip_ended_ = true;
}

void TheatrePage::teach_again() {
    if (help_shown_) toggle_help();
    if (watch_ == nullptr || !has_begun()) return;
    watch_->restart();
    known_.reset();
    learns_ = true;
    strip_ended_ = false;
    since_moved_ = 0;
}

QString TheatrePage::strip_words(int most) const {
    const HandDeeds done = deeds();
    QStringList marked, waiting;
    for (const TaughtLine& one : taught_lines(session_->scene(), hands_, input_->keys())) {
        const std::size_t deed = bit_of(one.deed);
        if (learns_ && known_.test(deed)) continue;
        (done.test(deed) ? marked : waiting) << strip_line(one.line, done.test(deed));
    }
    const int all = marked.size() + waiting.size();
    QStringList parts = marked + waiting;
    if (all > most) {
        parts = waiting.mid(0, most);
        if (learns_ && !marked.isEmpty()) parts.prepend(tr("✓ %1 of %2 done").arg(marked.size()).arg(all));
    }
    if (learns_) parts << tr("<b>Enter</b>&nbsp;ends these lines");
    parts << tr("<b>F1</b>&nbsp;all keys");
    return parts.join(QStringLiteral(" &nbsp; "));
}

/// From the beginning until a hand has moved for some seconds; in practice, where something is new to the
/// person, until each line was done, two minutes at most. Only work counts, by the ticks of the attempt: no
/// pause, no lock, no lost device, and not while the help is shown.
void TheatrePage::show_strip() {
    const bool begun = has_begun() && demonstrated_.isEmpty() && watch_ != nullptr;
    if (begun && !teaching_begun_) begin_teaching();
    const bool live =
        begun && shown_ == Panel::none && !help_shown_ && session_->phase() == AttemptPhase::running;
    const std::uint32_t tick = session_->health().ticks;
    if (live && since_moved_ >= 0) since_moved_ += session_->scene().tick_period() * (tick - strip_tick_);
    strip_tick_ = tick;
    if (begun && session_->display().moving_seen && since_moved_ < 0) since_moved_ = 0;
    if (learns_ && live) {
        const HandDeeds done = deeds();
        keep_learnt(done);
        if ((needed() & ~(done | known_)).none()) {
            learns_ = false;
            since_moved_ = 0;
        }
    }
    const bool shown = live && !strip_ended_ && since_moved_ <= (learns_ ? teaching_s : needed_s);
    if (shown) {
        const QString words = strip_words(most_lines);
        if (words != strip_all_) {
            strip_all_ = words;
            place_strip();
        }
    }
    if (shown != strip_->isVisible()) {
        strip_->setVisible(shown);
        if (shown) {
            place_strip();
            strip_->raise();
        }
    }
    clear_of_strip();
}

void TheatrePage::place_strip() {
    if (strip_all_.isEmpty() || session_ == nullptr || input_ == nullptr) return;
    const int width = this->width() - 40, foot = bar_->y() - 8;
    strip_text_->setTextFormat(Qt::RichText);
    int height = 0;
    for (int most = most_lines; most > 0; --most) {
        strip_text_->setText(strip_words(most));
        height = strip_->layout()->totalHeightForWidth(width);
        if (foot - height >= view_->y() + hud_height_above) break;
    }
    strip_->setGeometry(20, foot - height, width, height);
}

void TheatrePage::clear_of_strip() {
    const QRect picture = view_->geometry();
    view_->set_covered_foot(strip_->isVisible() ? std::max(0, picture.bottom() + 1 - strip_->y()) : 0);
}

void TheatrePage::toggle_help() {
    if (!demonstrated_.isEmpty() && !help_fits_) return;
    help_shown_ = !help_shown_;
    if (!help_shown_) {
        view_->set_cover({}, {});
        return;
    }
    strip_->hide();
    const bool of_daemon = input_->device() == MouseKeyboardInput::Device::of_daemon;
    QStringList lines = of_daemon
                            ? device_help(session_->scene(), hands_, input_->keys(), input_->help_lines())
                            : input_->help_lines();
    if (watch_ != nullptr && has_begun()) lines << tr("Enter\tshows the first steps again");
    view_->set_cover(of_daemon          ? hands_title_
                     : pad_ != nullptr  ? tr("Game controller")
                     : mice_ != nullptr ? tr("Two mice and keyboard")
                                        : tr("Mouse and keyboard"),
                     lines);
}

}  // namespace fulcrum::ui
