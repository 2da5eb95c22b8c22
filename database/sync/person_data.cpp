// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/person_data.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <filesystem>
#include <set>

#include "database/records/attempt_query.h"
#include "database/records/external_attempts.h"
#include "database/rows/csv_text.h"
#include "database/rows/json.h"
#include "database/store/audit.h"
#include "database/store/store_file.h"
#include "database/sync/erasure.h"
#include "database/sync/progress_watch.h"
#include "sim_core/numerics/output_file.h"
#include "sim_core/telemetry/event.h"

namespace fulcrum::database {
namespace {

namespace files = std::filesystem;

struct TableTitle {
    const char *table, *title;
};
constexpr TableTitle titles[] = {
    {"person", QT_TRANSLATE_NOOP("errors", "accounts")},
    {"attempt", QT_TRANSLATE_NOOP("errors", "attempts")},
    {"score", QT_TRANSLATE_NOOP("errors", "scores")},
    {"gate", QT_TRANSLATE_NOOP("errors", "criteria of the scores")},
    {"metric", QT_TRANSLATE_NOOP("errors", "measured values")},
    {"critical_error", QT_TRANSLATE_NOOP("errors", "critical errors")},
    {"pathology", QT_TRANSLATE_NOOP("errors", "reports on specimens")},
    {"trace_chunk", QT_TRANSLATE_NOOP("errors", "parts of recordings")},
    {"attempt_product", QT_TRANSLATE_NOOP("errors", "results of attempts, such as specimens")},
    {"attempt_asset", QT_TRANSLATE_NOOP("errors", "files that attempts were performed with")},
    {"attempt_origin", QT_TRANSLATE_NOOP("errors", "states that practice began with")},
    {"recording", QT_TRANSLATE_NOOP("errors", "recordings that are being made")},
    {"attempt_void", QT_TRANSLATE_NOOP("errors", "voided attempts")},
    {"attempt_reassignment", QT_TRANSLATE_NOOP("errors", "attempts that were assigned to another person")},
    {"comment", QT_TRANSLATE_NOOP("errors", "comments by and about the person")},
    {"error_review", QT_TRANSLATE_NOOP("errors", "confirmed and struck errors")},
    {"correction_request", QT_TRANSLATE_NOOP("errors", "requests for a correction")},
    {"rating", QT_TRANSLATE_NOOP("errors", "observer forms")},
    {"rating_item", QT_TRANSLATE_NOOP("errors", "items of observer forms")},
    {"rating_release", QT_TRANSLATE_NOOP("errors", "released observer forms")},
    {"rating_seen", QT_TRANSLATE_NOOP("errors", "reviews that were seen before a rating")},
    {"standing_override", QT_TRANSLATE_NOOP("errors", "decisions on the standing")},
    {"curriculum_move", QT_TRANSLATE_NOOP("errors", "moves to another curriculum")},
    {"personal_goal", QT_TRANSLATE_NOOP("errors", "personal goals")},
    {"personal_goal_end", QT_TRANSLATE_NOOP("errors", "personal goals that were dropped")},
    {"xapi_outbox", QT_TRANSLATE_NOOP("errors", "statements for a learning record store")},
    {"credential", QT_TRANSLATE_NOOP("errors", "passwords (stored as verifiers)")},
    {"person_role", QT_TRANSLATE_NOOP("errors", "roles")},
    {"cohort_member", QT_TRANSLATE_NOOP("errors", "memberships of cohorts")},
    {"cohort_educator", QT_TRANSLATE_NOOP("errors", "cohorts that the person teaches")},
    {"sign_in", QT_TRANSLATE_NOOP("errors", "last sign-in at each station")},
    {"audit_entry", QT_TRANSLATE_NOOP("errors", "audit log: what was done to and by the person")}};

/// A new folder that gets its name when it is complete. One export at a time to a name.
class NewFolder {
  public:
    explicit NewFolder(const std::string& path) : path_(path), part_(path + ".part") {
        std::error_code ignored;
        if (files::exists(files::symlink_status(path, ignored))) fail_file(path, EEXIST);
        if (::mkdir(part_.c_str(), 0700) != 0 && errno != EEXIST) fail_file(path, errno);
        lock_ = ::open(part_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        if (lock_ < 0) fail_file(path, errno);
        if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
            ::close(lock_);
            throw StoreError(
                StoreErrorKind::locked,
                {QT_TRANSLATE_NOOP("errors", "%1: another export is being written there"), path},
                QT_TRANSLATE_NOOP("errors", "wait until it is complete, or choose another name"));
        }
        // What a killed export left.
        for (const char* inside : {"index.html", "tables", "traces"})
            files::remove_all(files::path(part_) / inside, ignored);
        for (const char* inside : {"tables", "traces"})
            if (::mkdir((part_ + "/" + inside).c_str(), 0700) != 0) fail_file(path, errno);
    }
    ~NewFolder() {
        std::error_code ignored;
        if (!done_) files::remove_all(part_, ignored);
        ::close(lock_);
    }
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;
    std::string in(const std::string& name) const { return part_ + "/" + name; }
    void write(const std::string& name, const std::string& text) const {
        try {
            write_output_file(in(name), text, OutputFile::Existing::keep, OutputFile::Access::owner_only);
        } catch (const std::system_error& error) {
            fail_file(path_, error.code().value());
        }
    }
    void commit() {
        ::fsync(lock_);
        try {
            if (!rename_without_replacing(part_, path_)) fail_file(path_, EEXIST);
        } catch (const std::system_error& error) {
            fail_file(path_, error.code().value());
        }
        done_ = true;
    }

  private:
    std::string path_, part_;
    int lock_ = -1;
    bool done_ = false;
};

/// Columns that hold a time (ms); a 0 there is no time.
bool is_time(const std::string& column) {
    static const std::set<std::string> names = {"time",  "created", "started",   "computed", "sent",
                                                "read",  "asked",   "last",      "expires",  "changed",
                                                "begun", "ended",   "handed_in", "released", "queued"};
    return names.count(column) != 0;
}

std::vector<std::string> columns_of(Connection& connection, const std::string& table) {
    std::vector<std::string> names;
    Query rows(connection, QString("PRAGMA table_info('%1')").arg(QString::fromStdString(table)));
    while (rows.next()) names.push_back(rows.text(1));
    return names;
}

std::string cell(const QVariant& value, const std::string& column) {
    constexpr std::int64_t first_time = 1000000000000;  // 2001, in ms: smaller numbers are no times of ours
    if (value.isNull()) return {};
    if (value.type() == QVariant::ByteArray)
        return QStringLiteral("%1 bytes").arg(value.toByteArray().size()).toStdString();
    if (value.type() == QVariant::LongLong && is_time(column) && value.toLongLong() >= first_time)
        return iso_utc(value.toLongLong());
    if (value.type() == QVariant::Double) return csv_number(value.toDouble());
    return csv_text(value.toString().toStdString());
}

/// The rows of these people, as CSV; empty text: none.
std::string table_text(Connection& connection, const RowsAbout& rows_about,
                       const std::vector<std::string>& people, ProgressWatch& watch, std::int64_t& count) {
    const std::string table = rows_about.table;
    std::vector<std::string> columns = columns_of(connection, table);
    const auto is_secret = [&](const std::string& column) {
        return column.find("verifier") != std::string::npos || (table == "trace_chunk" && column == "data");
    };
    std::string selected, text;
    for (const std::string& column : columns) {
        // Recordings are many megabytes: how long they are says enough here, traces/ has what is in them.
        const std::string quoted = "\"" + column + "\"";
        selected += (selected.empty() ? "" : ", ") + (is_secret(column) ? "LENGTH(" + quoted + ")" : quoted);
        text += (text.empty() ? "" : ",") + csv_text(is_secret(column) ? column + " (length)" : column);
    }
    text += '\n';
    std::set<std::string> seen;
    for (const std::string& person : people) {
        Query rows = about_person(
            connection, "SELECT " + selected + " FROM " + table + " WHERE " + rows_about.where, person);
        while (rows.next()) {
            watch.row();
            std::string line;
            for (std::size_t i = 0; i < columns.size(); ++i)
                line += (i > 0 ? "," : "") + cell(rows.row()[i], columns[i]);
            if (!seen.insert(line).second) continue;  // of two accounts of the person
            text += line + '\n';
        }
    }
    count = static_cast<std::int64_t>(seen.size());
    return seen.empty() ? std::string() : text;
}

/// What was done to the person, and what the person did; payloads as they are. Reasons that others gave
/// belong to it: they were said about this person.
std::string audit_text(Connection& connection, const std::vector<std::string>& people, ProgressWatch& watch,
                       std::int64_t& count) {
    std::set<std::string> about_ids, actors(people.begin(), people.end());
    for (const std::string& person : people)
        for (const std::string& id : audit_objects_of(connection, person)) about_ids.insert(id);
    std::string text = "station,sequence,time,operation,object,actor,about,payload\n";
    Query rows(connection,
               "SELECT e.station_id, e.sequence, e.time, e.operation, e.object_id, e.actor_id, "
               "COALESCE(p.payload, '') FROM audit_entry e LEFT JOIN audit_payload p ON p.station_id = "
               "e.station_id AND p.sequence = e.sequence ORDER BY e.station_id, e.sequence");
    count = 0;
    while (rows.next()) {
        watch.row();
        const bool about = about_ids.count(rows.text(4)) != 0, by = actors.count(rows.text(5)) != 0;
        if (!about && !by) continue;
        ++count;
        // What somebody did to others is theirs: of it the deed alone.
        text += csv_text(rows.text(0)) + "," + rows.text(1) + "," + iso_utc(rows.integer(2)) + "," +
                csv_text(rows.text(3)) + "," + csv_text(about ? rows.text(4) : "") + "," +
                csv_text(by ? rows.text(5) : "somebody else") + "," + (about ? "yes" : "no") + "," +
                csv_text(about ? rows.text(6) : "") + "\n";
    }
    return text;
}

std::string escaped(const std::string& text) {
    return QString::fromStdString(text).toHtmlEscaped().toStdString();
}

class PackedText {
  public:
    explicit PackedText(const std::string& path) : path_(path) {
        const int file = ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0600);
        if (file < 0) fail_file(path, errno);
        packed_ = gzdopen(file, "wb3");
        if (packed_ == nullptr) {
            ::close(file);
            fail_file(path, ENOMEM);
        }
    }
    ~PackedText() {
        if (packed_ != nullptr) gzclose(packed_);
    }
    PackedText(const PackedText&) = delete;
    PackedText& operator=(const PackedText&) = delete;
    void add(const std::string& text) {
        if (!text.empty() && gzwrite(packed_, text.data(), static_cast<unsigned>(text.size())) <= 0)
            fail_file(path_, errno != 0 ? errno : EIO);
    }
    void finish() {
        const int code = gzclose(packed_);
        packed_ = nullptr;
        if (code != Z_OK) fail_file(path_, errno != 0 ? errno : EIO);
    }

  private:
    std::string path_;
    gzFile packed_ = nullptr;
};

constexpr double per_second = 1000;  // ticks

/// Movements and forces of an attempt, in SI-derived units with the unit in the heading.
void write_trace(const NewFolder& folder, const std::string& id, const Trace& trace) {
    PackedText file(folder.in("traces/" + id + "-samples.csv.gz"));
    file.add(
        "time_s,left_tip_x_mm,left_tip_y_mm,left_tip_z_mm,left_force_x_N,left_force_y_N,left_force_z_N,"
        "left_jaw_deg,right_tip_x_mm,right_tip_y_mm,right_tip_z_mm,right_force_x_N,right_force_y_N,"
        "right_force_z_N,right_jaw_deg,camera_x_mm,camera_y_mm,camera_z_mm\n");
    constexpr double mm = sample_length_unit * 1000, newton = sample_force_unit,
                     degrees = sample_angle_unit * 180 / 3.14159265358979323846;
    std::string text;
    for (const TickSample& sample : trace.samples) {
        char line[512];
        int at = std::snprintf(line, sizeof line, "%.3f", sample.tick / per_second);
        const auto put = [&](const char* form, double value) {
            at += std::snprintf(line + at, sizeof line - static_cast<std::size_t>(at), form, value);
        };
        for (const HandSample& hand : sample.hand) {
            for (const std::int32_t one : hand.tip) put(",%.4f", one * mm);
            for (const std::int32_t one : hand.force) put(",%.3f", one * newton);
            put(",%.3f", hand.jaw_angle * degrees);
        }
        for (const std::int32_t one : sample.camera.tip) put(",%.4f", one * mm);
        text.append(line, static_cast<std::size_t>(at));
        text += '\n';
        constexpr std::size_t portion = 1 << 18;
        if (text.size() < portion) continue;
        file.add(text);
        text.clear();
    }
    file.add(text);
    file.finish();
    std::string events = "time_s,event,hand,value,detail\n";
    for (const Event& event : trace.events)
        events += csv_number(event.tick / per_second) + "," + event_name(event.kind) + "," +
                  (event.hand == 0   ? "left"
                   : event.hand == 1 ? "right"
                                     : "") +
                  "," + csv_number(static_cast<double>(event.value)) + "," + std::to_string(event.detail) +
                  "\n";
    folder.write("traces/" + id + "-events.csv", events);
}

struct Index {
    std::string attempts, files;  ///< rows of its tables
};

std::string index_text(const Store& store, const std::vector<std::string>& people, const Index& index,
                       Translate words) {
    const auto say = [&](const Sentence& sentence) { return escaped(sentence.words(words)); };
    std::string accounts;
    for (const std::string& id : people) {
        Query row(store.connection(), "SELECT display_name, login, created FROM person WHERE id = ?");
        row.bind(id);
        if (row.next())
            accounts += "<li>" + escaped(row.text(0)) + " (" + escaped(row.text(1)) + "), " +
                        iso_utc(row.integer(2)) + "</li>\n";
    }
    return "<!DOCTYPE html>\n<html><head><meta "
           "charset=\"utf-8\"><title>Fulcrum</title><style>body{font-family:"
           "sans-serif;max-width:60em;margin:2em auto;padding:0 1em}table{border-collapse:collapse}td,th{"
           "border-bottom:1px solid #bbb;padding:.25em .8em .25em "
           "0;text-align:left}</style></head><body>\n<h1>" +
           say({QT_TRANSLATE_NOOP("errors", "What %1 has stored about a person"),
                store.programme_name().empty() ? std::string("Fulcrum") : store.programme_name()}) +
           "</h1>\n<ul>\n" + accounts + "</ul>\n<p>" + iso_utc(store.now()) + "</p>\n<h2>" +
           say(QT_TRANSLATE_NOOP("errors", "attempts")) + "</h2>\n<table>\n" + index.attempts +
           "</table>\n<h2>" + say(QT_TRANSLATE_NOOP("errors", "all files")) + "</h2>\n<table>\n" +
           index.files + "</table>\n<p>" +
           say(QT_TRANSLATE_NOOP(
               "errors",
               "Files of tables open in a spreadsheet; times are UTC. Recordings are packed "
               "with gzip. The password is not stored, only a verifier of it, which is not "
               "in these files.")) +
           "</p>\n</body></html>\n";
}

std::string file_row(const std::string& name, const std::string& what, std::int64_t rows) {
    return "<tr><td><a href=\"" + escaped(name) + "\">" + escaped(name) + "</a></td><td>" + escaped(what) +
           "</td><td>" + std::to_string(rows) + "</td></tr>\n";
}

/// The attempts of these people, the newest last, and where their recordings are.
std::vector<AttemptSummary> attempts_of(const Store& store, const std::vector<std::string>& people) {
    std::vector<std::string> ids;
    for (const std::string& person : people) {
        Query rows(store.connection(), "SELECT id FROM attempt WHERE person_id = ? ORDER BY started");
        rows.bind(person);
        while (rows.next()) ids.push_back(rows.text(0));
    }
    std::vector<AttemptSummary> attempts;
    for (const std::string& id : ids) attempts.push_back(query_attempt(store, id));
    return attempts;
}

bool has_trace(const Store& store, const std::string& attempt_id) {
    Query row(store.connection(), "SELECT 1 FROM trace_chunk WHERE attempt_id = ? LIMIT 1");
    row.bind(attempt_id);
    return row.next();
}

/// The recording of an attempt that was recorded elsewhere is in this store.
bool has_imported_trace(const Store& store, const std::string& attempt_id) {
    Query row(store.connection(), "SELECT 1 FROM attempt_product WHERE attempt_id = ? AND kind = ?");
    row.bind(attempt_id).bind(external_trace_product);
    return row.next();
}

/// What there is of the attempt's recording; the file to begin with, empty where there is none here.
std::string write_recording(const Store& store, const Session& director, const NewFolder& folder,
                            const std::string& id) {
    if (has_trace(store, id)) {
        write_trace(folder, id, stored_trace(store, id));
        return "traces/" + id + "-samples.csv.gz";
    }
    if (!has_imported_trace(store, id)) return {};
    const std::string name = "traces/" + id + "-trace.csv.gz";
    PackedText file(folder.in(name));
    file.add(ExternalAttempts(store).trace(director, id));
    file.finish();
    return name;
}

int recordings_of(const Store& store, const std::vector<std::string>& people) {
    std::int64_t count = 0;
    for (const std::string& person : people) {
        Query row(store.connection(),
                  "SELECT COUNT(*) FROM attempt a WHERE a.person_id = ? AND (EXISTS (SELECT 1 FROM "
                  "trace_chunk c WHERE c.attempt_id = a.id) OR EXISTS (SELECT 1 FROM attempt_product p WHERE "
                  "p.attempt_id = a.id AND p.kind = ?))");
        row.bind(person).bind(external_trace_product);
        if (row.next()) count += row.integer(0);
    }
    return static_cast<int>(count);
}

/// Of the whole work, where the recordings follow the tables.
constexpr double share_of_tables = 0.2;

/// All tables, the person's own row first. `folder` null: they are only counted.
std::vector<ErasedRows> write_tables(const Store& store, const std::vector<std::string>& people,
                                     const NewFolder* folder, std::string& files_text, Translate words,
                                     ProgressWatch& watch) {
    std::vector<ErasedRows> written;
    const auto add = [&](const std::string& table, const std::string& text, std::int64_t count) {
        if (count == 0) return;
        written.push_back({table, count});
        if (folder == nullptr) return;
        folder->write("tables/" + table + ".csv", text);
        files_text += file_row("tables/" + table + ".csv", title_of_table(table).words(words), count);
    };
    std::vector<RowsAbout> tables = {{"person", "id = ?"}};
    tables.insert(tables.end(), rows_about_people().begin(), rows_about_people().end());
    const double whole = folder == nullptr ? 1 : share_of_tables;
    std::size_t read = 0;
    const auto begin = [&] {
        watch.at(whole * static_cast<double>(read++) / static_cast<double>(tables.size() + 1),
                 QT_TRANSLATE_NOOP("errors", "reading what is stored"));
    };
    for (const RowsAbout& table : tables) {
        begin();
        std::int64_t count = 0;
        const std::string text = table_text(store.connection(), table, people, watch, count);
        add(table.table, text, count);
    }
    begin();
    std::int64_t count = 0;
    const std::string text = audit_text(store.connection(), people, watch, count);
    add("audit_entry", text, count);
    return written;
}

}  // namespace

Sentence title_of_table(const std::string& table) {
    for (const TableTitle& one : titles)
        if (table == one.table) return one.title;
    return table;
}

namespace {

/// Tables, recordings and index, into the folder, which has its name then.
void write_folder(const Store& store, const Session& director, const std::vector<std::string>& people,
                  const std::string& folder, ProgressWatch& watch, Translate words, PersonDataExport& done) {
    NewFolder made(folder);
    Index index;
    done.rows = write_tables(store, people, &made, index.files, words, watch);
    const std::vector<AttemptSummary> attempts = attempts_of(store, people);
    for (std::size_t i = 0; i < attempts.size(); ++i) {
        const AttemptMeta& meta = attempts[i].meta;
        const double share = static_cast<double>(i) / static_cast<double>(attempts.size());
        watch.at(share_of_tables + (1 - share_of_tables) * share,
                 QT_TRANSLATE_NOOP("errors", "writing the recordings"));
        std::string link;
        const std::string file = write_recording(store, director, made, meta.id);
        if (!file.empty()) {
            ++done.traces;
            link = "<a href=\"" + file + "\">traces/" + meta.id.substr(0, 8) + "…</a>";
        }
        index.attempts += "<tr><td>" + iso_utc(meta.started) + "</td><td>" + escaped(meta.task_id) +
                          "</td><td>" + row_of(attempt_modes, meta.mode).name + "</td><td>" +
                          row_of(attempt_states, attempts[i].state).name + "</td><td>" +
                          csv_number(attempts[i].points) + "</td><td>" + link + "</td></tr>\n";
    }
    made.write("index.html", index_text(store, people, index, words));
    // The log says so before the folder has its name: what was handed out is never missing there.
    Transaction transaction(store.connection());
    Audit(store).append(director, people.front(), "person.export",
                        json_object({{"folder", files::path(folder).filename().string()}}));
    transaction.commit();
    made.commit();
}

}  // namespace

PersonDataExport export_person_data(const Store& store, const Session& director, const std::string& person_id,
                                    const std::string& folder, const StoreProgress& progress,
                                    Translate words) {
    store.require(director, Operation::export_all, Subject::person(person_id));
    const std::vector<std::string> people = with_merged(store.connection(), person_id);
    PersonDataExport done;
    ProgressWatch watch(progress);
    try {
        if (folder.empty()) {
            std::string files_text;
            done.rows = write_tables(store, people, nullptr, files_text, words, watch);
            done.traces = recordings_of(store, people);
        } else {
            write_folder(store, director, people, folder, watch, words, done);
        }
    } catch (const ProgressWatch::Stopped&) {
        done = {};
        done.stopped = true;
    }
    return done;
}

}  // namespace fulcrum::database
