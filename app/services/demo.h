// SPDX-License-Identifier: GPL-3.0-or-later
// The demonstration: a store of its own with simulated attempts of a synthetic cohort, delivered packed
// (`fulcrum lab demonstration` makes it).
#pragma once

#include <string>

#include "ui/services/application_services.h"

namespace fulcrum::app {

inline constexpr const char* demo_asset = "demonstration/programme.db.zst";

/// Unpacks the delivered demonstration to `path`, brought up to this program's schema; replaces what is
/// there. False if stopped, and then no store is left. Throws InputError (it is missing, or is not the one
/// that was delivered with this program), StoreError.
bool unpack_demo(const std::string& path, const ui::Progress& progress);
/// The same from any packed store.
bool unpack_demo_file(const std::string& packed, const std::string& path, const ui::Progress& progress);

}  // namespace fulcrum::app
