// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/research/research_export.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <set>

#include "database/records/attempts.h"
#include "database/research/suppression.h"
#include "database/rows/connection.h"
#include "database/rows/crypto.h"
#include "database/rows/csv_text.h"
#include "database/rows/json.h"
#include "database/store/audit.h"
#include "database/sync/enrolment.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::database {
namespace {

constexpr std::int64_t minute_ms = 60000, day_ms = 86'400'000;
constexpr auto enough = static_cast<std::size_t>(least_people);
constexpr const char* hidden_word = "<5 or hidden";

using PersonSet = std::set<std::string>;

std::int64_t local_day(const AttemptMeta& meta) {
    return static_cast<std::int64_t>(
        std::floor(static_cast<double>(meta.started + minute_ms * meta.utc_offset_min) / double{day_ms}));
}

/// Three significant digits: an exact value would be found again in an export with names.
std::string rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return csv_number(std::strtod(text, nullptr));
}

/// One attempt with what is written of it.
struct Row {
    const AttemptSummary* attempt = nullptr;
    std::string person, id;  ///< drawn for this export
    std::string devices, mode;
    std::int64_t day = 0;
    int number = 0;  ///< of the person in the task
};

/// Which group of device classes a class of a task belongs to: classes of fewer than least_people people are
/// put together, with the next larger one where that is not enough. Empty: the task is left out.
std::map<std::string, std::string> groups_of(const std::map<std::string, PersonSet>& by_class) {
    std::vector<std::pair<std::size_t, std::string>> by_size;
    for (const auto& [name, people] : by_class) by_size.emplace_back(people.size(), name);
    std::sort(by_size.begin(), by_size.end());
    PersonSet together;
    std::map<std::string, std::string> groups;
    for (const auto& [size, name] : by_size) {
        const bool joins = size < enough || (!together.empty() && together.size() < enough);
        groups[name] = joins ? "" : name;
        if (joins) together.insert(by_class.at(name).begin(), by_class.at(name).end());
    }
    if (!together.empty() && together.size() < enough) return {};
    const auto joined =
        std::count_if(groups.begin(), groups.end(), [](const auto& one) { return one.second.empty(); });
    for (auto& [name, group] : groups)
        if (group.empty()) group = static_cast<std::size_t>(joined) == groups.size() ? "any" : "other";
    return groups;
}

std::map<std::string, std::map<std::string, std::string>> all_groups(
    const std::vector<AttemptSummary>& attempts) {
    std::map<std::string, std::map<std::string, PersonSet>> people;
    for (const AttemptSummary& one : attempts)
        people[one.meta.task_id][row_of(device_classes, one.meta.device_class).name].insert(
            one.meta.person_id);
    std::map<std::string, std::map<std::string, std::string>> groups;
    for (const auto& [task, by_class] : people) groups[task] = groups_of(by_class);
    return groups;
}

std::string drawn_id() {
    return random_uuid().substr(24);  // 48 bits; drawn again at each export
}

/// The attempts that are exported, in the order of their drawn ids: the order says nothing.
std::vector<Row> rows_of(const std::vector<AttemptSummary>& by_time) {
    const auto groups = all_groups(by_time);
    std::map<std::string, std::string> ids;
    std::map<std::string, std::int64_t> first_day;
    std::map<std::pair<std::string, std::string>, int> numbers;
    std::map<std::pair<std::string, std::string>, std::map<std::string, PersonSet>> modes;
    std::vector<Row> rows;
    for (const AttemptSummary& one : by_time) {
        const std::string &person = one.meta.person_id, &task = one.meta.task_id;
        first_day.emplace(person, local_day(one.meta));
        const int number = ++numbers[{person, task}];
        const auto& of_task = groups.at(task);
        const auto group = of_task.find(row_of(device_classes, one.meta.device_class).name);
        if (group == of_task.end()) continue;
        Row row{&one,
                ids.emplace(person, drawn_id()).first->second,
                drawn_id(),
                group->second,
                row_of(attempt_modes, one.meta.mode).name,
                local_day(one.meta) - first_day[person],
                number};
        modes[{task, row.devices}][row.mode].insert(person);
        rows.push_back(std::move(row));
    }
    for (Row& row : rows)
        for (const auto& [mode, people] : modes[{row.attempt->meta.task_id, row.devices}])
            if (people.size() < enough) row.mode = "any";
    std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        return std::tie(a.person, a.day, a.id) < std::tie(b.person, b.day, b.id);
    });
    return rows;
}

ResearchTable attempts_table(const std::vector<Row>& rows) {
    ResearchTable table{
        "attempts",
        {{"person", "-",
          "id drawn for this export; the same person has the same id within it. These are rows of single "
          "people: smaller counts follow from these rows than the tables of counts show"},
         {"attempt", "-", "id drawn for this export"},
         {"task", "-", "task"},
         {"devices", "-", "class of the input device; other, any: several classes, each with too few people"},
         {"mode", "-", "assessed or practice; any: where one of them has too few people"},
         {"number", "1", "the person's n-th attempt of this task, those that are left out included"},
         {"day", "d", "days since the person's first attempt"},
         {"state", "-", "how it ended"},
         {"duration", "s", "time of the attempt, three significant digits"},
         {"passed", "-", "1, 0, or empty without a score"},
         {"points", "1", "0 to 100, three significant digits; empty without a score"}},
        {}};
    for (const Row& row : rows) {
        const AttemptSummary& one = *row.attempt;
        table.rows.push_back({row.person, row.id, csv_text(one.meta.task_id), row.devices, row.mode,
                              std::to_string(row.number), std::to_string(row.day),
                              row_of(attempt_states, one.recorded_state).name, rounded(one.duration_s),
                              one.passed ? (*one.passed ? "1" : "0") : "",
                              one.points ? rounded(*one.points) : ""});
    }
    return table;
}

/// Values of metrics that least_people people or more have in this task and with these devices.
ResearchTable metrics_table(const Store& store, const std::vector<Row>& rows) {
    ResearchTable table{"metrics",
                        {{"attempt", "-", "id of the attempt in attempts.csv"},
                         {"metric", "-", "id of the metric"},
                         {"hand", "-", "left, right, or empty"},
                         {"tissue", "-", "label of the tissue, or empty"},
                         {"value", "as unit", "of the score in force, three significant digits"},
                         {"unit", "-", "unit of the value"}},
                        {}};
    std::map<std::string, const Row*> by_attempt;
    for (const Row& row : rows) by_attempt[row.attempt->meta.id] = &row;
    struct Value {
        const Row* row;
        std::vector<std::string> key, cells;
    };
    std::vector<Value> values;
    std::map<std::vector<std::string>, PersonSet> people;
    Query metrics(
        store.connection(),
        "SELECT s.attempt_id, m.id, m.hand, m.tissue, m.value, m.unit FROM metric m JOIN score s ON s.id = "
        "m.score_id WHERE s.in_force = 1 AND m.value IS NOT NULL ORDER BY m.id, m.hand, m.tissue");
    while (metrics.next()) {
        const auto found = by_attempt.find(metrics.text(0));
        if (found == by_attempt.end()) continue;
        const Row& row = *found->second;
        Value one{&row,
                  {row.attempt->meta.task_id, row.devices, metrics.text(1), metrics.text(2), metrics.text(3)},
                  {row.id, csv_text(metrics.text(1)), csv_text(metrics.text(2)), csv_text(metrics.text(3)),
                   rounded(metrics.real(4)), csv_text(metrics.text(5))}};
        people[one.key].insert(row.person);
        values.push_back(std::move(one));
    }
    for (Value& one : values)
        if (people[one.key].size() >= enough) table.rows.push_back(std::move(one.cells));
    std::sort(table.rows.begin(), table.rows.end());
    return table;
}

std::string shown(const std::optional<long long>& count) {
    return count ? std::to_string(*count) : hidden_word;
}

/// Of each task, how many people have passed it and how many have not. People do several tasks: no sum of
/// rows.
ResearchTable people_table(const std::vector<Row>& rows) {
    ResearchTable table{
        "people_by_task",
        {{"task", "-", "task"},
         {"passed", "people", "passed an attempt that counts; hidden counts follow from attempts.csv"},
         {"not_passed", "people", "performed it, and passed none that counts"},
         {"people", "people", "both together"}},
        {}};
    std::map<std::string, std::pair<PersonSet, PersonSet>> tasks;  // all, passed
    for (const Row& row : rows) {
        auto& [all, passed] = tasks[row.attempt->meta.task_id];
        all.insert(row.person);
        if (row.attempt->counting && *row.attempt->passed) passed.insert(row.person);
    }
    for (const auto& [task, people] : tasks) {
        const auto all = static_cast<long long>(people.first.size()),
                   passed = static_cast<long long>(people.second.size());
        const std::vector<long long> counts = {passed, all - passed, all};
        const std::vector<int> of(counts.begin(), counts.end());
        const auto safe = suppress_small({{counts, counts}, {of, of}}).front();
        table.rows.push_back({csv_text(task), shown(safe[0]), shown(safe[1]), shown(safe[2])});
    }
    return table;
}

/// Attempts by task and devices, with their sums.
ResearchTable attempts_by_device_table(const std::vector<Row>& rows) {
    std::map<std::string, std::size_t> tasks, devices;
    for (const Row& row : rows) tasks[row.attempt->meta.task_id] = devices[row.devices] = 0;
    std::size_t at = 0;
    for (auto& task : tasks) task.second = at++;
    at = 0;
    for (auto& device : devices) device.second = at++;
    const std::size_t height = tasks.size() + 1, width = devices.size() + 1;
    CountTable counts{std::vector<std::vector<long long>>(height, std::vector<long long>(width, 0)),
                      std::vector<std::vector<int>>(height, std::vector<int>(width, 0))};
    std::vector<std::vector<PersonSet>> people(height, std::vector<PersonSet>(width));
    for (const Row& row : rows) {
        for (const std::size_t r : {tasks[row.attempt->meta.task_id], height - 1}) {
            for (const std::size_t c : {devices[row.devices], width - 1}) {
                ++counts.counts[r][c];
                people[r][c].insert(row.person);
            }
        }
    }
    for (std::size_t r = 0; r < height; ++r)
        for (std::size_t c = 0; c < width; ++c) counts.people[r][c] = static_cast<int>(people[r][c].size());
    const auto safe = suppress_small(counts);
    ResearchTable table{"attempts_by_task", {{"task", "-", "task; all: their sum"}}, {}};
    for (const auto& device : devices)
        table.columns.push_back({device.first, "attempts", "attempts with these devices (attempts.csv)"});
    table.columns.push_back({"all", "attempts", "sum of the row"});
    const auto add = [&](const std::string& name, const std::vector<std::optional<long long>>& line) {
        std::vector<std::string> cells = {csv_text(name)};
        for (const auto& count : line) cells.push_back(shown(count));
        table.rows.push_back(std::move(cells));
    };
    for (const auto& [task, r] : tasks) add(task, safe[r]);
    add("all", safe.back());
    return table;
}

void add_line(std::string& csv, const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) csv += (i == 0 ? "" : ",") + cells[i];
    csv += "\r\n";
}

}  // namespace

std::string ResearchExport::csv(const ResearchTable& table) const {
    std::string csv;
    std::vector<std::string> names, units;
    for (const ResearchColumn& column : table.columns) {
        names.push_back(csv_text(column.name));
        units.push_back(csv_text(column.unit));
    }
    add_line(csv, names);
    add_line(csv, units);
    for (const std::vector<std::string>& row : table.rows) add_line(csv, row);
    return csv;
}

std::string ResearchExport::dictionary() const {
    std::string csv;
    add_line(csv, {"file", "column", "unit", "meaning"});
    for (const ResearchTable& table : tables)
        for (const ResearchColumn& column : table.columns)
            add_line(csv, {csv_text(table.name + ".csv"), csv_text(column.name), csv_text(column.unit),
                           csv_text(column.meaning)});
    return csv;
}

ResearchExport research_export(const Store& store, const Session& director) {
    store.require(director, Operation::export_cohort);
    store.require(director, Operation::export_person);
    if (scope_of(director.role(), Operation::export_cohort) != Scope::programme ||
        scope_of(director.role(), Operation::read_attempt) != Scope::programme)
        throw AccessDenied(operation_name(Operation::export_cohort), role_name(director.role()),
                           DenialReason::outside_people);
    require_whole_programme(store);
    AttemptFilter filter;
    filter.include_voided = filter.include_synthetic = false;
    filter.limit = -1;
    filter.for_table = true;
    std::vector<AttemptSummary> attempts = Attempts(store).list(director, filter);
    // What was recorded elsewhere has a name that someone typed, which may show who they are. What continues
    // another attempt is a part of the task.
    attempts.erase(std::remove_if(attempts.begin(), attempts.end(),
                                  [](const AttemptSummary& one) {
                                      return one.recorded_state == AttemptState::running ||
                                             is_external_task(one.meta.task_id) || one.meta.origin;
                                  }),
                   attempts.end());
    std::reverse(attempts.begin(), attempts.end());  // oldest first
    const std::vector<Row> rows = rows_of(attempts);
    PersonSet people;
    for (const Row& row : rows) people.insert(row.person);
    if (people.size() < enough)
        throw StoreError(
            StoreErrorKind::conflict,
            {QT_TRANSLATE_NOOP("errors", "no task was performed by %1 people or more"), least_people},
            QT_TRANSLATE_NOOP("errors", "fewer could be recognised; export when there are more"));
    ResearchExport result;
    result.people = static_cast<int>(people.size());
    result.attempts = static_cast<int>(rows.size());
    result.left_out = static_cast<int>(attempts.size() - rows.size());
    result.tables = {attempts_table(rows), metrics_table(store, rows), people_table(rows),
                     attempts_by_device_table(rows)};
    if (!store.is_read_only()) {
        Transaction transaction(store.connection());
        Audit(store).append(director, store.station_id(), "programme.export_research",
                            json_object({{"people", std::to_string(result.people)},
                                         {"attempts", std::to_string(result.attempts)}}));
        transaction.commit();
    }
    return result;
}

std::vector<std::string> write_research_files(const ResearchExport& research, const std::string& folder) {
    std::vector<std::unique_ptr<OutputFile>> files;
    const auto write = [&](const std::string& name, const std::string& text) {
        files.push_back(
            std::make_unique<OutputFile>((std::filesystem::path(folder) / (name + ".csv")).string(),
                                         OutputFile::Existing::replace, OutputFile::Access::owner_only));
        files.back()->write(text);
    };
    for (const ResearchTable& table : research.tables) write(table.name, research.csv(table));
    write("dictionary", research.dictionary());
    // Rows of two exports have other ids: tables of both would not fit together.
    std::vector<std::string> paths;
    for (const std::unique_ptr<OutputFile>& file : files) {
        file->commit();
        paths.push_back(file->path());
    }
    return paths;
}

}  // namespace fulcrum::database
