// SPDX-License-Identifier: GPL-3.0-or-later
// What mouse, keys and controller do, for the help of the theatre: with the keys of the present map.
#include "ui/theatre/help_lines.h"

#include <QCoreApplication>

#include "ui/theatre/mouse_keyboard_input.h"

namespace fulcrum::ui {
namespace {

using H = KeyAction;

class HelpWords {
    Q_DECLARE_TR_FUNCTIONS(fulcrum::ui::MouseKeyboardInput)
};

QString line(const QString& keys, const QString& what) {
    return keys + QLatin1Char('\t') + what;
}

/// Two or more groups of keys: "W A S D · R F".
QString groups(const KeyMap& keys, std::initializer_list<std::initializer_list<KeyAction>> all) {
    QStringList shown;
    for (const auto& one : all) shown << keys.words(one);
    return shown.join(QStringLiteral(" · "));
}

}  // namespace

QString mouse_button_words(bool left) {
    return left ? HelpWords::tr("Left button") : HelpWords::tr("Right button");
}

QString look_words(const KeyMap& keys) {
    const KeyMap usual = KeyMap::standard(keys.left_handed());
    const std::initializer_list<KeyAction> look = {H::scope_up, H::scope_left, H::scope_down, H::scope_right};
    for (const KeyAction one : look)
        if (keys.key(one) != usual.key(one)) return keys.words(look);
    return HelpWords::tr("Arrows");
}

QStringList scope_lines(const KeyMap& keys) {
    return {line(look_words(keys) + QStringLiteral(" · ") + keys.words({H::scope_in, H::scope_out}),
                 HelpWords::tr("scope: look · in, out")),
            line(groups(keys, {{H::post_back, H::post}, {H::head, H::head_back}}),
                 HelpWords::tr("scope: light post · camera head"))};
}

QString sound_line(const KeyMap& keys) {
    return line(keys.words(H::sound), HelpWords::tr("sound off, on"));
}

QString pause_line() {
    return HelpWords::tr("Escape, F1\tpause · this help");
}

namespace {

QStringList controller_lines(const KeyMap& keys, bool scope_alone) {
    const QStringList scope = {HelpWords::tr("Direction pad\tscope: look"),
                               HelpWords::tr("Upper button + pad\tscope: in, out · light post"),
                               HelpWords::tr("Back button + pad\tcamera head"), sound_line(keys),
                               HelpWords::tr("Start button\tpause and resume (Escape; F1: this help)")};
    if (scope_alone)
        return QStringList{
                   HelpWords::tr("Left stick\tmoves the handle of the scope; the lens goes the other way"),
                   HelpWords::tr("Left shoulder button + left stick\tin and out · light post"),
                   HelpWords::tr("Right stick\tlight post; with its shoulder button: camera head")} +
               scope;
    return QStringList{HelpWords::tr("Each stick\tmoves the handle of its hand; the tip goes the other way"),
                       HelpWords::tr("Shoulder button + stick\tin and out (up, down) · turn (left, right)"),
                       HelpWords::tr("Trigger\tcloses the jaws of that hand, then presses"),
                       HelpWords::tr("Press on a stick\tjaws stay closed, or open again"),
                       HelpWords::tr("Left, right button\tpedal of that hand (energy, suction)"),
                       HelpWords::tr("Lower button\tnext instrument of the hand that worked last")} +
           scope;
}

QStringList two_mice_lines(const KeyMap& keys) {
    return QStringList{
               HelpWords::tr("Each mouse\tmoves the handle of its hand; the tip goes the other way"),
               HelpWords::tr("Left button\tcloses the jaws of that hand while held"),
               HelpWords::tr("Wheel\tin and out"),
               HelpWords::tr("Right button + mouse\tin and out by little (up, down) · turns the shaft "
                             "(left, right)"),
               HelpWords::tr("Middle button\tpedal of that hand (energy, suction)"),
               HelpWords::tr("Side button\tnext instrument of that hand"),
               line(keys.words(H::other_hand), HelpWords::tr("the mice change hands")),
               line(groups(keys, {{H::left_jaws}, {H::right_jaws}}),
                    HelpWords::tr("jaws of the left, right hand stay closed, or open again"))} +
           scope_lines(keys) + QStringList{sound_line(keys), pause_line()};
}

QStringList scope_alone_lines(const KeyMap& keys) {
    return QStringList{
               HelpWords::tr("Mouse\tmoves the handle of the scope; the lens goes the other way"),
               HelpWords::tr("Wheel\tin and out"),
               HelpWords::tr("Shift + mouse\tturns the light post: the direction in which the scope looks"),
               HelpWords::tr("Ctrl + mouse\tturns the camera head: the image alone")} +
           scope_lines(keys) + QStringList{sound_line(keys), pause_line()};
}

}  // namespace

QStringList MouseKeyboardInput::help_lines() const {
    if (device_ == Device::controller) return controller_lines(keys_, scope_alone_);
    if (device_ == Device::two_mice) return two_mice_lines(keys_);
    if (scope_alone_) return scope_alone_lines(keys_);
    const QString other = mouse_button_words(keys_.left_handed());
    const QString hand = HelpWords::tr("%1: handle · in, out · turn · jaws");
    return QStringList{
               HelpWords::tr("Mouse\tmoves the handle of the active hand; the tip goes the other way"),
               line(mouse_button_words(!keys_.left_handed()), HelpWords::tr("closes the jaws while held")),
               line(other + QStringLiteral(", ") + keys_.words(H::other_hand),
                    HelpWords::tr("the other hand")),
               HelpWords::tr("Wheel\tin and out"),
               HelpWords::tr("Shift + mouse\tturns the shaft"),
               line(keys_.words(H::jaws),
                    HelpWords::tr("jaws of the active hand stay closed, or open again")),
               line(groups(keys_, {{H::left_up, H::left_left, H::left_down, H::left_right},
                                   {H::left_in, H::left_out},
                                   {H::left_turn_back, H::left_turn},
                                   {H::left_jaws}}),
                    hand.arg(HelpWords::tr("left hand"))),
               line(groups(keys_, {{H::right_up, H::right_left, H::right_down, H::right_right},
                                   {H::right_in, H::right_out},
                                   {H::right_turn_back, H::right_turn},
                                   {H::right_jaws}}),
                    hand.arg(HelpWords::tr("right hand"))),
               line(groups(keys_, {{H::pedal}, {H::exchange}}),
                    HelpWords::tr("pedal of the active hand (energy, suction) · its next instrument"))} +
           scope_lines(keys_) + QStringList{sound_line(keys_), pause_line()};
}

}  // namespace fulcrum::ui
