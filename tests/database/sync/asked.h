// SPDX-License-Identifier: GPL-3.0-or-later
// Who asks a store about what, for the table of server_reads.h.
#pragma once

#include <atomic>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "database/research/research_export.h"
#include "database/scoring/loaded_task.h"
#include "tests/database/sync/answers.h"

namespace fulcrum::database::test::reads {

/// What is asked about.
struct Subjects {
    std::vector<std::string> attempts, people, logins, cohorts, tasks, codes;
    std::string trainee;
    std::vector<AssetFile> files;
    Curriculum curriculum;
    LoadedTask loaded;
    BenchmarkKey key;
};

struct Asked {
    const Store& store;
    const Session& session;
    const Subjects& about;
    bool is(Role role) const { return session.role() == role; }
    std::int64_t today() const { return day_at(store.now(), 0); }
};

/// What one may not see: a store refuses it, and the row policies of a server hide it.
inline constexpr const char* hidden = "(hidden)";

template <typename Ask>
std::string unless_hidden(const Ask& ask) {
    try {
        return said(ask());
    } catch (const AccessDenied&) {
        return hidden;
    } catch (const StoreError& error) {
        if (error.kind() != StoreErrorKind::not_found) throw;
        return hidden;
    }
}

template <typename Ask>
std::string of_each(const std::vector<std::string>& names, const Ask& ask) {
    std::string all;
    for (const std::string& name : names) all += unless_hidden([&] { return ask(name); }) + '\n';
    return all;
}

template <typename Value>
std::string found(const std::optional<Value>& value) {
    return value ? said(*value) : hidden;
}

/// A trainee's account sees no form before it is released, so it does not count them either.
inline std::string said_to(const Session& session, const AttemptRatings& ratings) {
    return said(ratings.rows) + (session.role() == Role::trainee ? "" : std::to_string(ratings.hidden));
}

inline CohortTableOptions table_options(const Subjects& about) {
    CohortTableOptions options;
    options.tasks = about.tasks;
    options.curriculum = &about.curriculum;
    return options;
}

inline PersonDataOptions data_options(const Subjects& about, PointDetail detail) {
    PersonDataOptions options;
    options.tasks = about.tasks;
    options.curriculum = &about.curriculum;
    options.detail = detail;
    return options;
}

inline std::string overview_of_attempt(const Asked& q, const std::string& id) {
    std::atomic<std::size_t> chunks{0}, ticks{0};
    Attempts(q.store).read_overview(
        q.session, id, [&](std::size_t count) { chunks = count; },
        [&](std::size_t, const TraceOverview& part) { ticks += part.tick.size(); });
    return std::to_string(chunks.load()) + " chunks, " + std::to_string(ticks.load()) + " ticks";
}

/// Its ids of people and attempts are drawn for each export.
inline std::string said_of_research(const ResearchExport& research) {
    std::string all = std::to_string(research.people) + " people, " + std::to_string(research.attempts) +
                      " attempts, " + std::to_string(research.left_out) + " left out\n";
    for (const ResearchTable& table : research.tables) {
        const bool of_counts = table.name == "people_by_task" || table.name == "attempts_by_task";
        all +=
            table.name + ' ' + (of_counts ? research.csv(table) : std::to_string(table.rows.size())) + '\n';
    }
    return all;
}

/// Who is asked where the answer is about whatever the store has, and an account sees a part of it.
inline bool sees_everything(const Asked& q) {
    return q.is(Role::director);
}

}  // namespace fulcrum::database::test::reads
