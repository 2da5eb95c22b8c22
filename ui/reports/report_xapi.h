// SPDX-License-Identifier: GPL-3.0-or-later
// Statements of the Experience API 1.0.3 (IEEE 9274.1.1 is its successor) for a learning record store: one
// for each attempt and each released rating of it, and one that voids each of them that was taken out. The
// rater of a blind form is not named. A person is an account, named by the
// UUID, never by name or mail. The id of a statement follows from the address and the attempt's UUID, so a
// statement that is sent twice is known by the store.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ui/reports/report.h"

namespace fulcrum {
/// assets/schemas/xapi_profile.jsonld, embedded by the build: the terms and the kinds of statements.
extern const char* const xapi_profile_text;
}  // namespace fulcrum

namespace fulcrum::ui {

/// Named by every statement.
inline constexpr const char* xapi_profile_version = "urn:fulcrum:xapi:profile:1";

/// Throws InputError unless it is an http or https address.
void require_home_page(const std::string& home_page);
struct XapiStatement {
    std::string id, text;         ///< the text is JSON in one line
    std::string attempt_id = {};  ///< of the attempt that it is about
};
/// By task and start.
void each_xapi_statement(const PersonReport& report, const std::string& home_page,
                         const std::function<void(XapiStatement&&)>& visit);
/// A JSON array, by person, task and start; one line a statement.
std::string xapi_statements(const std::vector<PersonReport>& people, const std::string& home_page);

}  // namespace fulcrum::ui
