// SPDX-License-Identifier: GPL-3.0-or-later
// What a person at the window reads of an error: what is wrong and what to do, without internal names.
#pragma once

#include <QString>
#include <exception>

namespace fulcrum::ui {

QString error_text(const std::exception& error);

}  // namespace fulcrum::ui
