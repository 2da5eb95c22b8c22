// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/sounds.h"

#include <QSettings>
#include <algorithm>

namespace fulcrum::app {
namespace {

constexpr const char *sound_wanted_key = "sound/wanted", *sound_volume_key = "sound/volume";

}  // namespace

ui::SoundChoice Sounds::choice() {
    const QSettings kept;
    ui::SoundChoice choice;
    choice.wanted = kept.value(QLatin1String(sound_wanted_key), choice.wanted).toBool();
    bool is_number = false;
    const double volume = kept.value(QLatin1String(sound_volume_key), choice.volume).toDouble(&is_number);
    if (is_number && volume > 0 && volume <= 1) choice.volume = volume;
    return choice;
}

void Sounds::choose(const ui::SoundChoice& choice) {
    QSettings kept;
    kept.setValue(QLatin1String(sound_wanted_key), choice.wanted);
    kept.setValue(QLatin1String(sound_volume_key), std::clamp(choice.volume, 0.01, 1.0));
    choice_ = Sounds::choice();
    if (!choice_.wanted) output_.reset();
    play(newest_);
}

SoundOutput* Sounds::output() {
    if (!choice_.wanted) return nullptr;
    if (output_ == nullptr) output_ = std::make_unique<SoundOutput>(newest_);
    return output_.get();
}

void Sounds::play(SoundState state) {
    state.volume = choice_.volume;
    state.tests = tests_;
    SoundOutput* const one = output();  // knows what was counted before
    if (one != nullptr) one->play(state);
    newest_ = state;
}

void Sounds::test() {
    ++tests_;
    play(newest_);
}

Sentence Sounds::trouble() {
    SoundOutput* const one = output();
    return one != nullptr ? one->trouble() : Sentence();
}

}  // namespace fulcrum::app
