// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind the window: implements ui/services/application_services.h.
#pragma once

#include <memory>
#include <string>

#include "ui/services/application_services.h"

namespace fulcrum::app {

/// Opens the window and runs until it is closed; the exit status. `store`: as in make_services().
int run_window(const std::string& store = {});
std::string version_line();

/// `data_folder`: folder of the stores; empty: the user's data folder. `store`: the file, or the address of a
/// programme server, in place of the store there; empty: that store.
std::unique_ptr<ui::ApplicationServices> make_services(const std::string& data_folder = {},
                                                       const std::string& store = {});

}  // namespace fulcrum::app
