// SPDX-License-Identifier: GPL-3.0-or-later
// What somebody who can write the file may try, edit by edit: `db check` finds each and names the record.
#include <sqlite3.h>
#include <zstd.h>

#include "assessment/assets/assets.h"
#include "database/records/error_reviews.h"
#include "database/records/goals.h"
#include "database/records/ratings.h"
#include "database/records/standings.h"
#include "database/records/tissues.h"
#include "database/rows/connection.h"
#include "database/rows/crypto.h"
#include "database/store/accepted_assets.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

namespace files = std::filesystem;

/// A store with one of everything, copied for each edit.
class Forgery : public ::testing::Test {
  protected:
    static void SetUpTestSuite() {
        made = std::make_unique<Programme>();
        const Programme& p = *made;
        for (const char* login : {"administrator", "educator", "other_educator", "ann", "ben", "eve"})
            ids["{" + std::string(login) + "}"] = p.id(login);
        ids["{passed}"] = p.record("ann", true, 70, "A2", {Programme::slip()});
        ids["{failed}"] = p.record("ann", false, 20);
        ids["{voided}"] = p.record("ann");
        ids["{moved}"] = p.record("ben");
        const Person robot = p.people().ensure_synthetic(p.session("station"), "synthetic-robot", "Robot");
        ids["{robot}"] = robot.id;
        ids["{synthetic}"] = record_of_robot(robot.id);
        const Session& educator = p.session("educator");
        p.attempts().void_attempt(educator, ids["{voided}"], "the wrong scene was loaded");
        ids["{copy}"] = p.attempts().reassign(educator, ids["{moved}"], p.id("ann"), "it was Ann");
        ids["{comment}"] = Reviews(*p.store).write(educator, ids["{passed}"], 1, "Look here.", true);
        ids["{error review}"] = ErrorReviews(*p.store).add(educator, ids["{passed}"], Programme::slip(),
                                                           ErrorVerdict::confirmed, "seen");
        p.attempts().request_correction(p.session("ann"), ids["{failed}"], "this was not me");
        accept_files(p);
        Tissues(*p.store).set(educator, "B2", 0, {{"flap", {{"cut_energy", 400.0}}}}, "softer");
        ids["{decision}"] = Standings(*p.store).decide(educator, p.id("ann"), "A2",
                                                       StandingOverride::Kind::proficient, "seen in theatre");
        add_rating(p);
        ids["{dropped goal}"] =
            Goals(*p.store).set(p.session("ann"), {GoalOf::attempts, "A2", "", 3, 0}, 20'000);
        ids["{goal}"] = Goals(*p.store).change(p.session("ann"), ids["{dropped goal}"],
                                               {GoalOf::metric, "A2", "path_len", 900, 20'010}, 20'000);
        p.people().issue_one_time_password(p.session("administrator"), p.id("eve"));
        p.people().set_active(p.session("administrator"), p.id("other_educator"), false);
        ids["{cohort}"] = p.cohort;
        ids["{score of passed}"] = text("SELECT id FROM score WHERE attempt_id = '{passed}'");
        ids["{score of failed}"] = text("SELECT id FROM score WHERE attempt_id = '{failed}'");
        ids["{request}"] = text("SELECT id FROM correction_request");
        ids["{programme}"] = text("SELECT id FROM programme");
        ids["{scene}"] = text("SELECT scene_digest FROM attempt WHERE id = '{synthetic}'");
        made->store->connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");
        made->store.reset();
    }
    static void TearDownTestSuite() {
        made.reset();
        ids.clear();
    }
    static void add_rating(const Programme& p) {
        const Ratings ratings(*p.store);
        const Session& educator = p.session("educator");
        const ObserverForm form = load_form(asset_path("forms/goals.json"));
        ids["{rating}"] = ratings.begin(educator, ids["{passed}"], form);
        ratings.answer(educator, ids["{rating}"], FormAnswers(5, 3), std::vector<bool>(5, true), "steady");
        ratings.hand_in(educator, ids["{rating}"]);
        ratings.release(educator, ids["{passed}"]);
        ids["{form}"] = text_digest(form.text);
    }
    /// A scene, and limits that the other stations get.
    static void accept_files(const Programme& p) {
        const AcceptedAssets assets(*p.store);
        ids["{own scene}"] = sha256_hex("own scene");
        ids["{own limits}"] = sha256_hex("own limits");
        assets.accept(p.session("educator"), {"scenes/own.json", ids["{own scene}"]}, "our scene");
        assets.accept(p.session("educator"), {"benchmarks/own.json", ids["{own limits}"]}, "our limits",
                      "own limits");
    }
    static std::string record_of_robot(const std::string& person) {
        AttemptMeta meta = example_meta(person);
        meta.device_class = DeviceClass::synthetic;
        meta.operator_name = "expert";
        meta.scene_text = "{\"id\": \"scene\"}";
        meta.assets = {{"tasks/A2.json", sha256_hex("task")}, {"benchmarks/A2.json", sha256_hex("limits")}};
        Recorder recorder(made->path, made->session("station"), meta, made->clock.options());
        Programme::append_second(recorder);
        Programme::append_second(recorder, 1000);
        AttemptResult result = example_result(true, 99);
        result.score->pathology = "{\"version\":1}";
        result.score->critical_errors.push_back({0.5, "drop", "left", "", "drop"});
        result.products.push_back({"damage", {1, 2, 3}});
        recorder.finish(result);
        return recorder.attempt_id();
    }
    /// {names} replaced by ids.
    static std::string filled(std::string words) {
        for (const auto& [name, id] : ids) {
            for (auto at = words.find(name); at != std::string::npos; at = words.find(name, at))
                words.replace(at, name.size(), id);
        }
        return words;
    }
    static std::string text(const char* sql) {
        Query row(made->store->connection(), QString::fromStdString(filled(sql)));
        return row.next() ? row.text(0) : std::string();
    }
    /// Problems of a copy of the store after the edit.
    static std::vector<std::string> problems_after(const std::string& sql) {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("forged.db").toStdString();
        files::copy_file(made->path, path);
        edit(path, filled(sql));
        return problems_of(path);
    }
    static std::vector<std::string> problems_of(const std::string& path) {
        StoreOptions options;
        options.read_only = true;
        const Store store = Store::open(path, options);
        std::vector<std::string> problems;
        for (const CheckItem& item : store.check(store.station_session()).items)
            for (const Sentence& problem : item.problems) problems.push_back(problem.words());
        return problems;
    }
    static void edit(const std::string& path, const std::string& sql) {
        sqlite3* handle = nullptr;
        ASSERT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
        const auto drop = [](void* all, int, char** values, char**) {
            *static_cast<std::string*>(all) += "DROP TRIGGER " + std::string(values[0]) + ";";
            return 0;
        };
        std::string triggers;
        sqlite3_exec(handle, "SELECT name FROM sqlite_master WHERE type = 'trigger'", drop, &triggers,
                     nullptr);
        sqlite3_exec(handle, triggers.c_str(), nullptr, nullptr, nullptr);
        EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
            << sql << ": " << sqlite3_errmsg(handle);
        EXPECT_GT(sqlite3_total_changes(handle), 0) << sql << " changed nothing";
        sqlite3_close(handle);
    }
    static bool names(const std::vector<std::string>& problems, const std::string& words) {
        return std::any_of(problems.begin(), problems.end(), [&](const std::string& problem) {
            return problem.find(words) != std::string::npos;
        });
    }
    static std::unique_ptr<Programme> made;
    static std::map<std::string, std::string> ids;
};
std::unique_ptr<Programme> Forgery::made;
std::map<std::string, std::string> Forgery::ids;

struct Edit {
    const char* sql;
    const char* named;  ///< what a problem must say
};

const char* const delete_failed_score =
    "DELETE FROM gate WHERE score_id = '{score of failed}'; DELETE FROM metric WHERE score_id = '{score of "
    "failed}'; DELETE FROM score WHERE id = '{score of failed}';";

const std::vector<Edit> edits = {
    {"UPDATE attempt SET person_id = '{ann}' WHERE id = '{synthetic}'", "attempt {synthetic}: changed"},
    {"UPDATE attempt SET person_id = '{ben}' WHERE id = '{passed}'", "attempt {passed}: changed"},
    {"UPDATE attempt SET mode = 'practice' WHERE id = '{failed}'", "attempt {failed}: changed"},
    {"UPDATE attempt SET device_class = 'haptic' WHERE id = '{passed}'", "attempt {passed}: changed"},
    {"UPDATE attempt SET state = 'interrupted' WHERE id = '{failed}'", "attempt {failed}: changed"},
    {"UPDATE attempt SET state = 'running' WHERE id = '{failed}'", "attempt {failed}: changed"},
    {"UPDATE attempt SET started = started - 1 WHERE id = '{passed}'", "attempt {passed}: changed"},
    {"UPDATE attempt SET seed = seed + 1 WHERE id = '{passed}'", "attempt {passed}: changed"},
    {"UPDATE attempt SET limits = 'A2-site@9' WHERE id = '{passed}'", "attempt {passed}: changed"},
    {"UPDATE attempt SET state_hash = '0000000000000000' WHERE id = '{passed}'", "attempt {passed}: changed"},
    {"UPDATE attempt SET task_id = 'B1' WHERE id = '{passed}'", "attempt {passed}: changed"},
    {"UPDATE attempt SET task_version = 2 WHERE id = '{passed}'", "attempt {passed}: changed"},
    {"UPDATE attempt SET variant = 'narrow' WHERE id = '{passed}'", "attempt {passed}: changed"},
    {"UPDATE attempt SET fidelity = 'coarse' WHERE id = '{passed}'", "attempt {passed}: changed"},
    {"UPDATE attempt SET operator_name = '' WHERE id = '{synthetic}'", "attempt {synthetic}: changed"},
    {"UPDATE attempt SET program_version = '9' WHERE id = '{passed}'", "attempt {passed}: changed"},
    {"UPDATE attempt SET duration_s = 3 WHERE id = '{passed}'", "attempt {passed}: changed"},
    {"UPDATE attempt SET missed_ticks = 3 WHERE id = '{passed}'", "attempt {passed}: changed"},
    {"UPDATE attempt SET scene_digest = '' WHERE id = '{synthetic}'", "attempt {synthetic}: changed"},
    {"UPDATE attempt_asset SET digest = '{own scene}' WHERE file = 'tasks/A2.json'",
     "attempt {synthetic}: changed"},
    {"UPDATE attempt_asset SET file = 'tasks/B1.json' WHERE file = 'tasks/A2.json'",
     "attempt {synthetic}: changed"},
    {"DELETE FROM attempt_asset WHERE file = 'benchmarks/A2.json'", "attempt {synthetic}: changed"},
    {"DELETE FROM attempt_asset WHERE attempt_id = '{copy}'", "attempt {copy}: changed"},
    {"INSERT INTO attempt_asset VALUES ('{passed}', 'tasks/A2.json', '{own scene}')",
     "attempt {passed}: changed"},
    {"UPDATE asset_acceptance SET reason = 'so' WHERE digest = '{own scene}'",
     "accepted file {own scene}: changed"},
    {"DELETE FROM asset_acceptance WHERE digest = '{own scene}'", "accepted file {own scene}: gone"},
    {"INSERT INTO asset_acceptance VALUES ('forged', 'tasks/A2.json', '{educator}', 1, 'ours too')",
     "accepted file forged: the audit log has no row for it"},
    {"UPDATE asset_text SET text = 'other limits'", "content of accepted file {own limits}: changed"},
    {"DELETE FROM asset_text", "content of accepted file {own limits}: gone"},
    {"UPDATE scene_text SET text = '{}'", "scene {scene}: changed"},
    {"DELETE FROM scene_text", "attempt {synthetic}: its scene is missing"},
    {"INSERT INTO attempt SELECT 'forged', person_id, station_id, task_id, task_version, mode, device_class, "
     "device, operator_name, variant, seed, fidelity, scene, scene_digest, curriculum, limits, "
     "program_version, cpu_features, started, utc_offset_min, state, duration_s, wall_s, missed_ticks, "
     "lost_samples, events, state_hash, force_devices FROM attempt WHERE id = '{passed}'; INSERT INTO "
     "trace_chunk SELECT "
     "'forged', stream, number, first_tick, last_tick, records, checksum, data FROM trace_chunk WHERE "
     "attempt_id = '{passed}'",
     "attempt forged: the audit log has no row for it"},
    {"DELETE FROM correction_request WHERE attempt_id = '{failed}'; DELETE FROM gate WHERE score_id = "
     "'{score "
     "of failed}'; DELETE FROM metric WHERE score_id = '{score of failed}'; DELETE FROM score WHERE id = "
     "'{score of failed}'; DELETE FROM trace_chunk WHERE attempt_id = '{failed}'; DELETE FROM attempt WHERE "
     "id = '{failed}'",
     "attempt {failed}: gone"},
    {delete_failed_score, "score {score of failed} of attempt {failed}: gone"},
    {"UPDATE score SET in_force = 0 WHERE id = '{score of failed}'", "score {score of failed} of attempt"},
    {"UPDATE score SET passed = 1, points = 80 WHERE id = '{score of failed}'",
     "score {score of failed} of attempt {failed}: changed"},
    {"UPDATE score SET limits = 'A2-site@9' WHERE id = '{score of failed}'", "score {score of failed}"},
    {"UPDATE gate SET passed = 1 WHERE score_id = '{score of failed}'", "score {score of failed}"},
    {"UPDATE metric SET value = 1 WHERE score_id = '{score of failed}'", "score {score of failed}"},
    {"DELETE FROM critical_error", "of attempt {synthetic}: changed"},
    {"UPDATE pathology SET report = '{\"version\":2}'", "of attempt {synthetic}: changed"},
    {"DELETE FROM pathology", "of attempt {synthetic}: changed"},
    {"UPDATE score SET points = 99 WHERE id = '{score of passed}'; DELETE FROM audit_payload WHERE sequence "
     "= "
     "(SELECT sequence FROM audit_entry WHERE object_id = '{score of passed}')",
     "its payload is gone, and no erasure is in the audit log"},
    {"UPDATE score SET points = 99 WHERE id = '{score of passed}'; DELETE FROM audit_payload WHERE sequence "
     "= "
     "(SELECT sequence FROM audit_entry WHERE object_id = '{score of passed}')",
     "score {score of passed}: the audit log has no row for it"},
    {"DELETE FROM attempt_void WHERE attempt_id = '{voided}'", "void of attempt {voided}: gone"},
    {"INSERT INTO attempt_void VALUES ('{failed}', '{educator}', 1, 'so that it does not count')",
     "void of attempt {failed}: the audit log has no row for it"},
    {"UPDATE attempt_void SET reason = 'another' WHERE attempt_id = '{voided}'",
     "void of attempt {voided}: changed"},
    {"DELETE FROM attempt_reassignment", "reassignment of attempt {moved}: gone"},
    {"INSERT INTO person_role VALUES ('{ann}', 'director')", "person {ann}: changed"},
    {"DELETE FROM person_role WHERE person_id = '{educator}'", "person {educator}: changed"},
    {"UPDATE credential SET verifier = (SELECT verifier FROM credential WHERE person_id = '{ann}') WHERE "
     "person_id = '{administrator}'",
     "person {administrator}: changed"},
    {"UPDATE credential SET one_time = 0, expires = NULL WHERE person_id = '{eve}'", "person {eve}: changed"},
    {"UPDATE programme SET recovery_verifier = (SELECT verifier FROM credential WHERE person_id = '{ann}')",
     "programme {programme}: changed"},
    {"UPDATE person SET kind = 'real' WHERE id = '{robot}'", "person {robot}: changed"},
    {"UPDATE person SET display_name = 'Another' WHERE id = '{ann}'", "person {ann}: changed"},
    {"UPDATE person SET active = 1 WHERE id = '{other_educator}'", "person {other_educator}: changed"},
    {"UPDATE comment SET text = 'Well done.'", "comment {comment} of attempt {passed}: changed"},
    {"UPDATE comment SET author_id = '{other_educator}'", "comment {comment} of attempt {passed}: changed"},
    {"UPDATE comment SET sent = 0", "comment {comment} of attempt {passed}: gone"},
    {"DELETE FROM comment", "comment {comment} of attempt {passed}: gone"},
    {"INSERT INTO comment VALUES ('forged', '{passed}', '{educator}', 1, 'Excellent.', 1, 1, 0)",
     "comment forged: the audit log has no row for it"},
    {"UPDATE error_review SET verdict = 'struck'",
     "error review {error review} of attempt {passed}: changed"},
    {"UPDATE error_review SET reason = 'no'", "error review {error review} of attempt {passed}: changed"},
    {"UPDATE error_review SET tick = 250", "error review {error review} of attempt {passed}: changed"},
    {"DELETE FROM error_review", "error review {error review} of attempt {passed}: gone"},
    {"INSERT INTO error_review VALUES ('forged', '{passed}', '{educator}', 999, 'slip', 1, 2, 7, 'struck', "
     "'no', 1)",
     "error review forged: the audit log has no row for it"},
    {"DELETE FROM correction_request", "correction request {request}: gone"},
    {"UPDATE rating_item SET value = 5 WHERE number = 2", "rating {rating} of attempt {passed}: changed"},
    {"DELETE FROM rating_item WHERE number = 4", "rating {rating} of attempt {passed}: changed"},
    {"INSERT INTO rating_item VALUES ('{rating}', 5, 'sixth', 5)",
     "rating {rating} of attempt {passed}: changed"},
    {"UPDATE rating SET rater_id = '{other_educator}'", "rating {rating} of attempt {passed}: changed"},
    {"UPDATE rating SET attempt_id = '{failed}'", "rating {rating} of attempt {passed}: changed"},
    {"UPDATE rating SET blinding = 'lifted'", "rating {rating} of attempt {passed}: changed"},
    {"UPDATE rating SET remark = 'poor'", "rating {rating} of attempt {passed}: changed"},
    {"UPDATE rating SET handed_in = 0", "rating {rating} of attempt {passed}: gone"},
    {"DELETE FROM rating_release; DELETE FROM rating_item; DELETE FROM rating",
     "rating {rating} of attempt {passed}: gone"},
    {"INSERT INTO rating VALUES ('forged', '{passed}', '{educator}', 'goals@1', '{form}', 'kept', 1, 1, '')",
     "rating forged: the audit log has no row for it"},
    {"UPDATE form_text SET text = '{}'", "form {form} of attempt {passed}: changed"},
    {"DELETE FROM rating_release", "release of rating {rating} of attempt {passed}: gone"},
    {"UPDATE rating_release SET time = 1", "release of rating {rating} of attempt {passed}: changed"},
    {"UPDATE personal_goal SET target = 950 WHERE id = '{goal}'", "goal {goal}: changed"},
    {"DELETE FROM personal_goal WHERE id = '{goal}'", "goal {goal}: gone"},
    {"INSERT INTO personal_goal VALUES ('forged', '{ben}', 'attempts', '', '', 9, 0, 1)",
     "goal forged: the audit log has no row for it"},
    {"DELETE FROM personal_goal_end", "end of goal {dropped goal}: gone"},
    {"INSERT INTO personal_goal_end VALUES ('{goal}', 1)",
     "end of goal {goal}: the audit log has no row for it"},
    {"UPDATE tissue_value SET value = 1", "tissues of task B2 1: changed"},
    {"INSERT INTO tissue_setting VALUES ('B2', 2, '{educator}', 1, 'softer still')",
     "tissues of task B2 2: the audit log has no row for it"},
    {"INSERT INTO cohort_member VALUES ('{cohort}', '{eve}')", "cohort {cohort}: changed"},
    {"DELETE FROM cohort_educator WHERE cohort_id = '{cohort}'", "cohort {cohort}: changed"},
    {"UPDATE cohort SET name = 'Year 2'", "cohort {cohort}: changed"},
    {"DELETE FROM standing_override", "decision {decision}: gone"},
    {"INSERT INTO standing_override VALUES ('forged', '{ben}', 'A2', 'proficient', '{educator}', 1, 'so')",
     "decision forged: the audit log has no row for it"},
    {"UPDATE setting SET value = '1' WHERE key = 'demo'", "setting demo: changed"},
    {"INSERT INTO setting VALUES ('baseline_wanted', '1')",
     "setting baseline_wanted: the audit log has no row for it"},
    {"UPDATE station SET name = 'elsewhere'", "station "},
    {"DELETE FROM trace_chunk WHERE attempt_id = '{passed}'; UPDATE attempt SET events = 0 WHERE id = "
     "'{passed}'",
     "trace {passed}: gone"},
    {"DELETE FROM trace_chunk WHERE attempt_id = '{synthetic}' AND number = 1", "trace {synthetic}: changed"},
    {"UPDATE trace_chunk SET data = (SELECT data FROM trace_chunk c WHERE c.attempt_id = '{failed}' AND "
     "c.stream = 1), checksum = (SELECT checksum FROM trace_chunk c WHERE c.attempt_id = '{failed}' AND "
     "c.stream = 1), number = 1 WHERE attempt_id = '{synthetic}' AND stream = 1 AND number = 1; UPDATE "
     "attempt_product SET data = x'00'",
     "product damage is damaged"},
    {"DELETE FROM attempt_product", "trace {synthetic}: changed"},
    {"DELETE FROM audit_payload WHERE sequence = 9; DELETE FROM audit_entry WHERE sequence = 9",
     "audit rows 9 to 9 are missing"},
    {"UPDATE audit_payload SET payload = '{}' WHERE sequence = 9", "audit row 9: its payload was changed"},
    {"DELETE FROM audit_payload; DELETE FROM audit_entry", "no digests of the records"},
};

TEST_F(Forgery, TheStoreIsGoodBefore) {
    EXPECT_TRUE(problems_of(made->path).empty()) << problems_of(made->path).front();
}

TEST_F(Forgery, EveryEditByHandIsFoundAndNamed) {
    for (const Edit& edit : edits) {
        const std::vector<std::string> problems = problems_after(edit.sql);
        std::string all;
        for (const std::string& problem : problems) all += "\n  " + problem;
        EXPECT_TRUE(names(problems, filled(edit.named)))
            << filled(edit.sql) << "\nmust be named: " << filled(edit.named) << "\nfound:" << all;
    }
}

TEST_F(Forgery, AnotherPersonsTraceUnderTheSameNumbersIsFound) {
    const std::vector<std::string> problems = problems_after(
        "DELETE FROM trace_chunk WHERE attempt_id = '{failed}'; INSERT INTO trace_chunk SELECT '{failed}', "
        "stream, number, first_tick, last_tick, records, checksum, data FROM trace_chunk WHERE attempt_id = "
        "'{synthetic}' AND number = 0; UPDATE attempt SET events = 4 WHERE id = '{failed}'");
    EXPECT_FALSE(problems.empty());
}

TEST_F(Forgery, ASecondBaselineIsNamed) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("forged.db").toStdString();
    files::copy_file(made->path, path);
    edit(path, filled("UPDATE person SET kind = 'real' WHERE id = '{robot}'; INSERT INTO setting VALUES "
                      "('baseline_wanted', '1')"));
    { const Store opened = Store::open(path); }  // enters all records again
    EXPECT_TRUE(names(problems_of(path), "enters all records again"));
}

/// The program writes these for itself, without a row in the audit log: docs/FORMATS.md says which and why.
const char* const bookkeeping[] = {
    "UPDATE sign_in SET last = last + 1",
    "DELETE FROM sign_in",
    "INSERT INTO sign_in_wait VALUES ('ann', 3, 1, '', 0)",
    "UPDATE cohort SET version = version + 1",
    "UPDATE programme SET version = version + 1",
    "UPDATE comment SET read = sent",
    "INSERT INTO rating_seen VALUES ('{failed}', '{educator}', 1)",
    "INSERT INTO comment (id, attempt_id, author_id, time_s, text, created) VALUES ('draft', '{failed}', "
    "'{educator}', 1, 'so', 1)",
    "INSERT INTO xapi_outbox (endpoint, id, person_id, number, statement, changed) VALUES ('e', 's', "
    "'{ann}', "
    "1, '{}', 1)",
};

TEST_F(Forgery, WhatNoDigestHasIsBookkeepingAlone) {
    for (const char* sql : bookkeeping) {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("counted.db").toStdString();
        files::copy_file(made->path, path);
        {
            const Store store = Store::open(path);
            store.connection().execute(QString::fromStdString(filled(sql)));
        }
        const std::vector<std::string> problems = problems_of(path);
        EXPECT_TRUE(problems.empty()) << sql << ": " << problems.front();
    }
}

/// Chunks that somebody made with care: the checksum of each is right.
std::vector<std::pair<const char*, TraceChunk>> crafted_chunks(const TraceChunk& good) {
    std::vector<std::uint8_t> plain(1U << 20U);
    plain.resize(ZSTD_decompress(plain.data(), plain.size(), good.data.data(), good.data.size()));
    std::vector<std::pair<const char*, TraceChunk>> chunks;
    const auto add = [&](const char* what, const std::vector<std::uint8_t>& bytes) {
        TraceChunk chunk = good;
        chunk.data.resize(ZSTD_compressBound(bytes.size()));
        chunk.data.resize(ZSTD_compress(chunk.data.data(), chunk.data.size(), bytes.data(), bytes.size(), 1));
        chunks.emplace_back(what, chunk);
    };
    const auto changed = [&](std::size_t at, std::uint8_t value) {
        std::vector<std::uint8_t> bytes = plain;
        bytes.at(at) = value;
        return bytes;
    };
    add("layout version", changed(0, 9));
    add("another stream", changed(1, 3));
    add("more records", changed(2, 0xff));
    add("fewer columns", changed(4, 3));
    add("cut off", {plain.begin(), plain.begin() + static_cast<std::ptrdiff_t>(plain.size() / 2)});
    std::vector<std::uint8_t> longer = plain;
    longer.insert(longer.end(), 100, 0);
    add("something after its end", longer);
    add("ones", std::vector<std::uint8_t>(plain.size(), 0xff));
    add("header only", {plain.begin(), plain.begin() + 6});
    chunks.emplace_back("no zstd", good);
    chunks.back().second.data.assign(100, 0x5a);
    chunks.emplace_back("empty", good);
    chunks.back().second.data.clear();
    chunks.emplace_back("ticks", good);
    ++chunks.back().second.last_tick;
    chunks.emplace_back("count", good);
    --chunks.back().second.count;
    for (auto& [what, chunk] : chunks) chunk.checksum = blake2b(chunk.data, 16);
    return chunks;
}

TEST_F(Forgery, EveryCraftedChunkIsDecodedAndNamed) {
    TraceChunk good;
    {
        StoreOptions options;
        options.read_only = true;
        const Store store = Store::open(made->path, options);
        Query row(store.connection(),
                  "SELECT first_tick, last_tick, records, data FROM trace_chunk WHERE attempt_id = ? AND "
                  "stream = 1");
        row.bind(ids["{passed}"]);
        ASSERT_TRUE(row.next());
        good.stream = TraceStream::inputs;
        good.first_tick = static_cast<std::uint32_t>(row.integer(0));
        good.last_tick = static_cast<std::uint32_t>(row.integer(1));
        good.count = static_cast<std::uint32_t>(row.integer(2));
        good.data = row.bytes(3);
    }
    for (const auto& [what, chunk] : crafted_chunks(good)) {
        const auto hex = [](const Bytes& bytes) { return "x'" + to_hex(bytes) + "'"; };
        const auto problems = problems_after(
            "UPDATE trace_chunk SET data = " + hex(chunk.data) + ", checksum = " + hex(chunk.checksum) +
            ", last_tick = " + std::to_string(chunk.last_tick) +
            ", records = " + std::to_string(chunk.count) + " WHERE attempt_id = '{passed}' AND stream = 1");
        EXPECT_TRUE(names(problems, filled("attempt {passed}, stream 1: chunk 0 is damaged"))) << what;
    }
}

}  // namespace
}  // namespace fulcrum::database::test
