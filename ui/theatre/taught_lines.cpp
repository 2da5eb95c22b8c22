// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/taught_lines.h"

#include <QCoreApplication>
#include <algorithm>

#include "sim_core/devices/device_table.h"
#include "ui/theatre/help_lines.h"

namespace fulcrum::ui {
namespace {

constexpr int taught_count = 7;

/// In braces: keys of the person's map. The lines of `instrument` are those of moved to exchanged; where one
/// is empty the device has no such line.
struct TaughtRow {
    const char* kind;
    const char* instrument[taught_count];
    const char* scope;             ///< where the device moves the scope too; else keys do
    const char* alone[4];          ///< the scope as the only instrument: moved, in and out, post, head
    const char* clutch = "";       ///< its button; "": it has none
    const char* free_button = "";  ///< the button for energy, which is the clutch where it is not the pedal
};

constexpr TaughtRow taught_rows[] = {
    {"mouse-keyboard",
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Mouse\tmoves the handle of the active hand; the tip goes the other way"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{second}, {other}\tthe other hand"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Wheel\tin and out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Shift + mouse\tturns the shaft"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "{first} · {jaws}\tcloses the jaws while held · they stay closed, or open again"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{pedal}\tpedal of the active hand (energy, suction)"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{exchange}\tnext instrument of the active hand")},
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{look} · {in}\tscope: look · in, out"),
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Mouse\tmoves the handle of the scope; the lens goes the other way"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Wheel\tin and out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Shift + mouse\tturns the light post: the direction in which the scope looks"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Ctrl + mouse\tturns the camera head: the image alone")}},
    {"two-mice",
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Each mouse\tmoves the handle of its hand; the tip goes the other way"),
      "", QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Wheel, or right button + mouse\tin and out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Right button + mouse sideways\tturns the shaft"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Left button\tcloses the jaws of that hand while held"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Middle button\tpedal of that hand (energy, suction)"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Side button\tnext instrument of that hand")},
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{look} · {in}\tscope: look · in, out"),
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Right mouse\tmoves the handle of the scope; the lens goes the other way"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Wheel, or right button + mouse\tin and out"),
      QT_TRANSLATE_NOOP(
          "fulcrum::taught_lines",
          "Right button + mouse sideways\tturns the light post: the direction in which the scope looks"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{head}\tturns the camera head: the image alone")}},
    {"controller",
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Each stick\tmoves the handle of its hand; the tip goes the other way"),
      "", QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Shoulder button + stick up, down\tin and out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Shoulder button + stick sideways\tturns the shaft"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Trigger · press on a stick\tcloses the jaws · they stay closed, or open again"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Left, right button\tpedal of that hand (energy, suction)"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Lower button\tnext instrument of the hand that worked last")},
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Direction pad · upper button + pad\tscope: look · in, out"),
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Left stick\tmoves the handle of the scope; the lens goes the other way"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Left shoulder button + left stick\tin and out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Right stick\tturns the light post: the direction in which the scope looks"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Right shoulder button + right stick\tturns the camera head: the image alone")}},
    {"virtual",
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Script of the device\tmoves the handle of a hand; the tip goes the other way"),
      "", QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Script of the device\tin and out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Script, or {turn}\tturns the shaft"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Script, or {each_jaws}\tcloses the jaws"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Script, or {pedal}\tpedal (energy, suction)"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Script, or {exchange}\tnext instrument")},
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Script of the device\tscope: look · in, out"),
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Script of the device\tmoves the handle of the scope; the lens goes the other way"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Script of the device\tin and out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Script, or {post}\tturns the light post: the direction in which the scope looks"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{head}\tturns the camera head: the image alone")},
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Script of the device")},
    {"touch",
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Stylus\tis the handle of its hand; the tip goes the other way"),
      "", QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Stylus away from you, towards you\tin, out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Turn the stylus between your fingers\tturns the shaft"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Front button of the stylus\tcloses the jaws while held"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Rear button of the stylus\tpedal of that hand (energy, suction)"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{exchange} on the keyboard\tnext instrument")},
     "",
     {"", "", "", ""},
     "",
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Rear button of the stylus")},
    {"force-dimension",
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Handle of the device\tis that of its hand; the tip goes the other way"),
      "", QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Handle away from you, towards you\tin, out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Turn the handle, or {turn}\tturns the shaft"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Gripper; without one its first button\tcloses the jaws while held"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "First button; without a gripper the second\tpedal of that hand (energy, suction)"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{exchange} on the keyboard\tnext instrument")},
     "",
     {"", "", "", ""},
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Second button; without a gripper the fourth"),
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "First button; without a gripper the second")},
    {"haply",
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Grip of the Inverse3\tis the handle of its hand; the tip goes the other way"),
      "", QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Grip away from you, towards you\tin, out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Turn the VerseGrip, or {turn}\tturns the shaft"),
      QT_TRANSLATE_NOOP(
          "fulcrum::taught_lines",
          "First button, or {each_jaws}\tcloses the jaws · the keys: they stay closed, or open again"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Second button, or {pedal}\tpedal (energy, suction)"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Third button, or {exchange}\tnext instrument")},
     "",
     {"", "", "", ""},
     "",
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Second button")},
    {"openigtlink",
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Tracked instrument\tmoves as you hold it; its handle is that of its hand"),
      "", QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Instrument away from you, towards you\tin, out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Turn the instrument\tturns the shaft"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Its sensor, or {each_jaws}\tcloses the jaws · the keys: they stay closed, or open "
                        "again"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{pedal} on the keyboard\tpedal (energy, suction)"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{exchange} on the keyboard\tnext instrument")},
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Tracked scope\tscope: look · in, out"),
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Tracked scope\tmoves as you hold it; the lens goes the other way"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Scope away from you, towards you\tin, out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Turn the scope\tturns the light post: the direction in which the scope looks"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{head}\tturns the camera head: the image alone")},
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Clutch button of the instrument")},
    {"space-mouse",
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Cap to the side, up, down\tmoves the handle of its hand; the tip goes the other "
                        "way"),
      "", QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Cap away from you, towards you\tin, out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Turn the cap\tturns the shaft"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "First button\tcloses the jaws while held"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Second button, or {pedal}\tpedal (energy, suction)"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Third button, or {exchange}\tnext instrument")},
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Cap of the SpaceMouse\tscope: look · in, out"),
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Cap to the side, up, down\tmoves the handle of the scope; the lens goes the other "
                        "way"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Cap away from you, towards you\tin, out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Turn the cap\tturns the light post: the direction in which the scope looks"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{head}\tturns the camera head: the image alone")},
     "",
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Second button")},
    {"trainer",
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Instrument of the trainer\tmoves as you hold it; the tip goes the other way"),
      "", QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Push, pull the instrument\tin, out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Turn the instrument\tturns the shaft"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Close its handle, or {each_jaws}\tcloses the jaws · the keys: they stay closed, or "
                        "open again"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Pedal of the trainer, or {pedal}\tpedal (energy, suction)"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Button of the trainer, or {exchange}\tnext instrument")},
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Scope of the trainer\tscope: look · in, out"),
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Scope of the trainer\tmoves as you hold it; the lens goes the other way"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Push, pull the scope\tin, out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Turn the scope\tturns the light post: the direction in which the scope looks"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{head}\tturns the camera head: the image alone")},
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Clutch button of the trainer")},
    {"joystick",
     {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Instrument on the joystick\tmoves as you hold it; the tip goes the other way"),
      "", QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Push, pull the instrument\tin, out"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Turn the instrument, or {turn}\tturns the shaft"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                        "Close its handle, or {each_jaws}\tcloses the jaws · the keys: they stay closed, or "
                        "open again"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Pedal of the trainer, or {pedal}\tpedal (energy, suction)"),
      QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Button of the trainer, or {exchange}\tnext instrument")},
     "",
     {"", "", "", ""},
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Clutch button of the joystick")}};

/// A device of the daemon that has no row of its own; {device} is its title.
constexpr TaughtRow general_row = {
    "",
    {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                       "{device}\tits handle is that of its hand; the tip goes the other way"),
     "", QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Handle away from you, towards you\tin, out"),
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Turn the handle, or {turn}\tturns the shaft"),
     QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                       "Jaws of the handle, or {each_jaws}\tcloses the jaws · the keys: they stay closed, or "
                       "open again"),
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Pedal of the device, or {pedal}\tpedal (energy, suction)"),
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{exchange} on the keyboard\tnext instrument")},
    QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{device}\tscope: look · in, out"),
    {QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                       "{device}\tits handle is that of the scope; the lens goes the other way"),
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "Handle away from you, towards you\tin, out"),
     QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                       "Turn the handle\tturns the light post: the direction in which the scope looks"),
     QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{head}\tturns the camera head: the image alone")}};

/// Its own, or one that holds for every device.
const TaughtRow& row_for(const std::string& kind) {
    for (const TaughtRow& row : taught_rows)
        if (kind == row.kind) return row;
    return general_row;
}

QString title_of_kind(const std::string& kind) {
    const DeviceRow* const row = find_row(device_table, kind);
    if (row == nullptr) return QString::fromStdString(kind);
    const QString title = QCoreApplication::translate("fulcrum::device_list", row->title);
    return title != QLatin1String(row->title) ? title : QCoreApplication::translate("errors", row->title);
}

QString words(const char* line, const KeyMap& keys, const std::string& kind) {
    using K = KeyAction;
    struct Place {
        const char* name;
        QString keys;
    };
    const QString dot = QStringLiteral(" · ");
    const Place places[] = {
        {"{first}", mouse_button_words(!keys.left_handed())},
        {"{second}", mouse_button_words(keys.left_handed())},
        {"{other}", keys.words(K::other_hand)},
        {"{jaws}", keys.words(K::jaws)},
        {"{each_jaws}", keys.words({K::left_jaws, K::right_jaws})},
        {"{turn}", keys.words({K::left_turn_back, K::left_turn}) + dot +
                       keys.words({K::right_turn_back, K::right_turn})},
        {"{pedal}", keys.words(K::pedal)},
        {"{exchange}", keys.words(K::exchange)},
        {"{look}", look_words(keys)},
        {"{in}", keys.words({K::scope_in, K::scope_out})},
        {"{post}", keys.words({K::post_back, K::post})},
        {"{head}", keys.words({K::head, K::head_back})},
        {"{device}", title_of_kind(kind)},
    };
    // What is put in may have a brace of its own: a key has that name.
    const QString from = QCoreApplication::translate("fulcrum::taught_lines", line);
    QString all;
    for (int i = 0; i < from.size();) {
        const Place* const found = std::find_if(
            std::begin(places), std::end(places),
            [&](const Place& place) { return from.midRef(i).startsWith(QLatin1String(place.name)); });
        if (found == std::end(places)) {
            all += from[i++];
        } else {
            all += found->keys;
            i += static_cast<int>(qstrlen(found->name));
        }
    }
    return all;
}

/// Instruments of the scene that the device moves.
int driven_hands(const Scene& scene, const TaughtHands& hands) {
    return static_cast<int>(std::count_if(
        scene.instruments.begin(), scene.instruments.end(),
        [&](const InstrumentSpec& spec) { return hands.drives[static_cast<std::size_t>(spec.hand)]; }));
}

bool is_of_window(const std::string& kind) {
    return kind == "mouse-keyboard" || kind == "two-mice" || kind == "controller";
}

const TaughtRow& row_of_hands(const Scene& scene, const TaughtHands& hands) {
    return is_of_window(hands.kind) || driven_hands(scene, hands) > 0 ? row_for(hands.kind) : taught_rows[0];
}

const TaughtRow& row_of_scope(const TaughtHands& hands) {
    return is_of_window(hands.kind) || hands.drives[hand_count] ? row_for(hands.kind) : taught_rows[0];
}

/// Of a device that moves one of two hands.
QString mouse_for_the_other(const TaughtHands& hands) {
    return hands.drives[0] ? QCoreApplication::translate("fulcrum::taught_lines",
                                                         "Mouse · wheel\tthe right hand · in and out")
                           : QCoreApplication::translate("fulcrum::taught_lines",
                                                         "Mouse · wheel\tthe left hand · in and out");
}

/// Where one part's button is the pedal of both hands, or no button is.
const char* pedal_line(const TaughtRow& row, const TaughtHands& hands) {
    constexpr const char* of_part[hand_count + 1] = {
        QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                          "Button of the left device, or {pedal}\tpedal (energy, suction)"),
        QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                          "Button of the right device, or {pedal}\tpedal (energy, suction)"),
        QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                          "Button of the scope’s device, or {pedal}\tpedal (energy, suction)")};
    if (hands.pedal == pedal_of_each_hand) return row.instrument[static_cast<int>(HandDeed::pedal)];
    if (hands.pedal < 0 || hands.pedal > hand_count)
        return QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{pedal} on the keyboard\tpedal (energy, suction)");
    return of_part[hands.pedal];
}

QString clutch_line(const TaughtRow& row, const TaughtHands& hands) {
    const bool own = hands.clutch == ClutchButton::own && *row.clutch != '\0';
    const char* const button = own ? row.clutch : row.free_button;
    const QString name =
        *button != '\0' ? QCoreApplication::translate("fulcrum::taught_lines", button)
                        : QCoreApplication::translate("fulcrum::taught_lines", "Clutch button of the device");
    return name + QLatin1Char('\t') +
           QCoreApplication::translate("fulcrum::taught_lines", "clutch: while held, only the handle moves");
}

}  // namespace

HandDeeds needed_deeds(const Scene& scene, const TaughtHands& hands) {
    HandDeeds needed = needed_deeds(scene, is_one_mouse(scene, hands));
    needed.set(bit_of(HandDeed::clutched), hands.clutch != ClutchButton::none);
    return needed;
}

bool is_one_mouse(const Scene& scene, const TaughtHands& hands) {
    if (hands.kind == "two-mice" || hands.kind == "controller") return false;
    return driven_hands(scene, hands) < static_cast<int>(scene.instruments.size());
}

std::vector<TaughtLine> taught_lines(const Scene& scene, const TaughtHands& hands, const KeyMap& keys) {
    const HandDeeds needed = needed_deeds(scene, hands);
    std::vector<TaughtLine> lines;
    const auto add = [&](HandDeed deed, const QString& line) {
        if (needed.test(bit_of(deed))) lines.push_back({deed, line});
    };
    const TaughtRow& scope = row_of_scope(hands);
    if (scene.instruments.empty()) {
        const HandDeed deeds[] = {HandDeed::scope_moved, HandDeed::inserted, HandDeed::post_turned,
                                  HandDeed::head_turned};
        for (int i = 0; i < 4; ++i) add(deeds[i], words(scope.alone[i], keys, hands.kind));
        add(HandDeed::clutched, clutch_line(scope, hands));
        return lines;
    }
    const TaughtRow& row = row_of_hands(scene, hands);
    for (int i = 0; i < taught_count; ++i) {
        const auto deed = static_cast<HandDeed>(i);
        const bool mouse = deed == HandDeed::other_hand && *row.instrument[i] == '\0';
        const bool pedal = deed == HandDeed::pedal && &row != &taught_rows[0];
        add(deed, mouse ? mouse_for_the_other(hands)
                        : words(pedal ? pedal_line(row, hands) : row.instrument[i], keys, hands.kind));
    }
    add(HandDeed::clutched, clutch_line(driven_hands(scene, hands) > 0 ? row : scope, hands));
    add(HandDeed::scope_moved, words(scope.scope, keys, hands.kind));
    return lines;
}

QStringList device_help(const Scene& scene, const TaughtHands& hands, const KeyMap& keys,
                        const QStringList& mouse) {
    const bool moves_scope_alone = !scene.instruments.empty() && driven_hands(scene, hands) == 0;
    QStringList help;
    for (const TaughtLine& one : taught_lines(scene, hands, keys))
        if (!moves_scope_alone || one.deed == HandDeed::scope_moved || one.deed == HandDeed::clutched)
            help << one.line;
    if (moves_scope_alone) return help + mouse;
    if (!scene.instruments.empty()) {
        help << words(
                    QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                                      "{each_jaws}\tjaws of the left, right hand stay closed, or open again"),
                    keys, hands.kind)
             << words(QT_TRANSLATE_NOOP("fulcrum::taught_lines", "{turn}\tturns the shaft: left, right hand"),
                      keys, hands.kind)
             << words(QT_TRANSLATE_NOOP("fulcrum::taught_lines",
                                        "{pedal} · {exchange}\tpedal · next instrument, with every device"),
                      keys, hands.kind);
    }
    if (scene.camera) help += scope_lines(keys);
    help << sound_line(keys) << pause_line();
    help.removeDuplicates();
    return help;
}

}  // namespace fulcrum::ui
